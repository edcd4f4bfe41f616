// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bounds/AnalyticInverse.h"

#include "Core/Base/MadeOnDemand.h"
#include "Core/Bernstein/Krawczyk.h"
#include "Core/Bernstein/PieceForm.h"
#include "Core/Bernstein/TensorPolynomial.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>

namespace pixelexact
{
namespace
{
/// Rounds up by more than the roundings of some thousand sums and products of bounds.
double Above(double bound)
{
  return bound * (1.0 + 1e-11) + kUnderflow;
}

/// Row k holds the coefficients of s^k in the Bernstein polynomials of degree n at t = (1 + s) / 2.
/// Their errors are at most gamma(2 n) times the coefficients of C(n,i) (1 + s)^n / 2^n.
std::vector<double> MakeTaylorTable(int n)
{
  const auto size = static_cast<std::size_t>(n) + 1;
  std::vector<double> table(size * size, 0.0);
  double binomial = std::ldexp(1.0, -n); // C(n,i) / 2^n
  for (std::size_t i = 0; i < size; ++i)
  {
    std::vector<double> row(size, 0.0);
    row[0] = binomial;
    for (std::size_t factor = 0; factor + 1 < size; ++factor)
    {
      const double sign = factor < i ? 1.0 : -1.0;
      for (std::size_t k = factor + 1; k > 0; --k)
      {
        row[k] += sign * row[k - 1];
      }
    }
    for (std::size_t k = 0; k < size; ++k)
    {
      table[k * size + i] = row[k];
    }
    binomial *= static_cast<double>(size - 1 - i) / static_cast<double>(i + 1);
  }
  return table;
}

std::span<const double> TaylorTable(int n)
{
  static const MadeOnDemand<std::vector<double>> kept(static_cast<std::size_t>(kMaxDegree) + 1);
  return kept.Get(static_cast<std::size_t>(n),
    [n] { return std::make_unique<const std::vector<double>>(MakeTaylorTable(n)); });
}

/// Replaces Bernstein coefficients along a direction by coefficients of powers of s.
void ToPowers(const Degrees& degree, int direction, std::span<double> coefficients)
{
  const auto size = static_cast<std::size_t>(degree[static_cast<std::size_t>(direction)]) + 1;
  const std::span<const double> table = TaylorTable(static_cast<int>(size) - 1);
  const std::size_t stride = StrideOf(degree, direction);
  std::vector<double> line(size);
  for (std::size_t outer = 0; outer < coefficients.size(); outer += size * stride)
  {
    for (std::size_t inner = 0; inner < stride; ++inner)
    {
      double* const first = &coefficients[outer + inner];
      for (std::size_t i = 0; i < size; ++i)
      {
        line[i] = first[i * stride];
      }
      for (std::size_t k = 0; k < size; ++k)
      {
        double sum = 0.0;
        for (std::size_t i = 0; i < size; ++i)
        {
          sum += table[k * size + i] * line[i];
        }
        first[k * stride] = sum;
      }
    }
  }
}

/// A function over a box as base + sum of a_ijk s_1^i s_2^j s_3^k. The sum is off by at most
/// error (1 + R)^D for |s| <= R, D the sum of the degrees.
struct Powers
{
  Degrees degree{};
  double base = 0.0;
  std::vector<double> a;
  double error = 0.0;

  [[nodiscard]] int Total() const { return degree[0] + degree[1] + degree[2]; }
};

/// The least piece of a form, of the levels that it may have, that holds a box.
struct HoldingPiece
{
  int level = 0;
  PieceForm::Piece piece{};
  Vec3 from{ 0.0 }; ///< the box in the piece, in [0, 1]^3
  Vec3 to{ 1.0 };
};

HoldingPiece PieceThatHolds(const Box3& box, int highest)
{
  for (int level = highest;; --level)
  {
    const double across = std::ldexp(1.0, level); // pieces along a direction
    HoldingPiece found;
    found.level = level;
    bool holds = true;
    for (int d = 0; d < 3; ++d)
    {
      const double at = (box.lower[d] + 1.0) / 2.0 * across;
      const double number = std::clamp(std::floor(at), 0.0, across - 1.0);
      found.piece[static_cast<std::size_t>(d)] = static_cast<int>(number);
      found.from[d] = at - number;
      found.to[d] = (box.upper[d] + 1.0) / 2.0 * across - number;
      holds = holds && found.to[d] <= 1.0;
    }
    if (holds || level == 0)
    {
      return found;
    }
  }
}

Powers PowersOver(const Space& space, const double* modes, const Box3& box)
{
  const HoldingPiece at = PieceThatHolds(box, PieceForm::LevelOf(space.MaxOrder()));
  const PieceForm& form = PieceForm::Of(space, at.level);
  Powers powers;
  powers.degree = form.Degree();
  powers.a.resize(form.Size());
  form.Convert(Part::Value, at.piece, modes, powers.a);
  double error = form.ErrorBound(Part::Value, at.piece, modes);
  for (int d = 0; d < 3; ++d)
  {
    if (at.from[d] > 0.0 || at.to[d] < 1.0)
    {
      error +=
        RestrictionError(powers.degree[static_cast<std::size_t>(d)], LargestMagnitude(powers.a));
      Restrict(powers.degree, d, at.from[d], at.to[d], powers.a);
    }
  }
  // Small numbers round by less.
  powers.base = powers.a.front();
  error += kUnitRoundoff * 2.0 * LargestMagnitude(powers.a);
  for (double& b : powers.a)
  {
    b -= powers.base;
  }
  // Tables and sums, direction by direction; every step's coefficients are sums over
  // |C(n,i)| (1 + s)^n / 2^n, hence the growth by (1 + R)^D.
  error += Gamma(4 * powers.Total() + 24) * LargestMagnitude(powers.a);
  for (int d = 0; d < 3; ++d)
  {
    ToPowers(powers.degree, d, powers.a);
  }
  powers.error = Above(error);
  if (!std::isfinite(powers.base) || !std::isfinite(LargestMagnitude(powers.a)))
  {
    powers.error = kInfinity;
  }
  return powers;
}

/// The sum of the magnitudes of the coefficients of each total degree, from 0.
std::vector<double> SumsByDegree(const Degrees& degree, std::span<const double> a)
{
  std::vector<double> sums(static_cast<std::size_t>(degree[0] + degree[1] + degree[2]) + 1, 0.0);
  std::size_t at = 0;
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int k = 0; k <= degree[2]; ++k)
      {
        sums[static_cast<std::size_t>(i + j + k)] += std::fabs(a[at++]);
      }
    }
  }
  return sums;
}

/// Bounds of a function of s over |s| <= R, from its sums by degree and the error of its powers.
struct Majorant
{
  double value = 0.0;
  double slope = 0.0; ///< of the sum of the magnitudes of its derivatives
};

Majorant MajorantAt(std::span<const double> sums, double error, double radius)
{
  Majorant found;
  double power = 1.0; // R^(m-1)
  for (std::size_t m = 1; m < sums.size(); ++m)
  {
    found.slope += static_cast<double>(m) * sums[m] * power;
    power *= radius;
    found.value += sums[m] * power;
  }
  found.value += sums[0];
  const auto total = static_cast<double>(sums.size() - 1);
  if (error > 0.0)
  {
    found.slope += error * total * std::pow(1.0 + radius, total - 1.0);
    found.value += error * std::pow(1.0 + radius, total);
  }
  return { Above(found.value), Above(found.slope) };
}

constexpr double kMaxBound = 1e300;
} // namespace

Vec3 AnalyticInverse::CoordinatesOf(const Vec3& x) const
{
  Vec3 y;
  for (int d = 0; d < 3; ++d)
  {
    const auto at = static_cast<std::size_t>(d);
    y[d] = (x[d] - elementCentre[at]) * inverseSize - origin[at];
  }
  return { inverse[0] * y.x + inverse[1] * y.y + inverse[2] * y.z,
    inverse[3] * y.x + inverse[4] * y.y + inverse[5] * y.z,
    inverse[6] * y.x + inverse[7] * y.y + inverse[8] * y.z };
}

Vec3 AnalyticInverse::DirectionOf(const Vec3& d) const
{
  const Vec3 y = d * inverseSize;
  return { inverse[0] * y.x + inverse[1] * y.y + inverse[2] * y.z,
    inverse[3] * y.x + inverse[4] * y.y + inverse[5] * y.z,
    inverse[6] * y.x + inverse[7] * y.y + inverse[8] * y.z };
}

std::size_t AnalyticInverse::DiscOf(double most) const
{
  std::size_t k = 0;
  while (k < reach.size() && !(reach[k] > 0.0 && most <= reach[k]))
  {
    ++k;
  }
  return k;
}

AnalyticInverse MakeAnalyticInverse(const Mesh& mesh, int element, const Box3& box)
{
  AnalyticInverse made;
  made.box = box;
  made.centre = 0.5 * (box.lower + box.upper);
  made.halfWidth = 0.5 * (box.upper - box.lower);
  const auto at = static_cast<std::size_t>(element);
  std::copy_n(&mesh.centre[3 * at], 3, made.elementCentre.begin());
  made.inverseSize = 1.0 / mesh.size[at];
  const Space& space = mesh.map.SpaceOf(element);
  std::array<Powers, 3> phi;
  SmallMatrix matrix{};
  bool isKnown = true;
  for (std::size_t c = 0; c < 3; ++c)
  {
    phi[c] = PowersOver(
      space, mesh.map.Coefficients(element) + c * static_cast<std::size_t>(space.Modes()), box);
    made.origin[c] = phi[c].base + phi[c].a[0];
    isKnown = isKnown && phi[c].error < kMaxBound;
    for (int d = 0; d < 3; ++d)
    {
      matrix[c][static_cast<std::size_t>(d)] =
        phi[c].degree[static_cast<std::size_t>(d)] > 0 ? phi[c].a[StrideOf(phi[c].degree, d)] : 0.0;
    }
  }
  const auto inverse = Inverse(3, matrix);
  if (!isKnown || !inverse)
  {
    return made;
  }
  std::array<std::vector<double>, 3> sums;
  std::array<double, 3> error{};
  double norm = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    std::copy_n((*inverse)[i].begin(), 3, &made.inverse[3 * i]);
    std::vector<double> row(phi[0].a.size(), 0.0);
    double size = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double factor = (*inverse)[i][c];
      for (std::size_t k = 0; k < row.size(); ++k)
      {
        row[k] += factor * phi[c].a[k];
      }
      const double largest = LargestMagnitude(phi[c].a);
      error[i] += std::fabs(factor) *
        (phi[c].error + 8.0 * kUnitRoundoff * (largest + std::fabs(made.origin[c])));
      size += std::fabs(factor) * (1.0 + std::fabs(made.origin[c]));
    }
    norm = std::max(norm, size);
    // The constant term is the origin, and the linear ones are z, up to rounding.
    row[0] = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      if (phi[0].degree[static_cast<std::size_t>(d)] > 0)
      {
        row[StrideOf(phi[0].degree, d)] -= static_cast<std::size_t>(d) == i ? 1.0 : 0.0;
      }
    }
    sums[i] = SumsByDegree(phi[0].degree, row);
  }
  for (std::size_t k = 0; k < kDiscRadii.size(); ++k)
  {
    double reach = kInfinity;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Majorant bound = MajorantAt(sums[i], error[i], kDiscRadii[k]);
      reach = std::min(reach, bound.slope < 1.0 ? kDiscRadii[k] - bound.value : 0.0);
    }
    // z of a point rounds by less than this.
    const double rounded = reach * (1.0 - 1e-9) - 64.0 * kUnitRoundoff * norm;
    made.reach[k] = rounded > 0.0 ? rounded : 0.0;
  }
  return made;
}

std::vector<DiscBounds> BoundsOverDiscs(const Expansion& function, int element, const Box3& box)
{
  const Space& space = function.SpaceOf(element);
  std::vector<DiscBounds> bounds(static_cast<std::size_t>(function.components));
  for (std::size_t c = 0; c < bounds.size(); ++c)
  {
    Powers powers = PowersOver(
      space, function.Coefficients(element) + c * static_cast<std::size_t>(space.Modes()), box);
    powers.a[0] = 0.0;
    const std::vector<double> sums = SumsByDegree(powers.degree, powers.a);
    for (std::size_t k = 0; k < kDiscRadii.size(); ++k)
    {
      // f and f(c) each have the error.
      const double bound = MajorantAt(sums, 2.0 * powers.error, kDiscRadii[k]).value;
      bounds[c][k] = bound < kMaxBound ? bound : kInfinity;
    }
  }
  return bounds;
}

double InterpolationError(const AnalyticInverse& inverse, const DiscBounds& bounds,
  const Vec3& middle, const Vec3& half, const Vec3& offset, int n)
{
  double least = kInfinity;
  for (std::size_t k = 0; k < kDiscRadii.size(); ++k)
  {
    double axis = kInfinity; // (rho + 1/rho) / 2
    for (int d = 0; d < 3; ++d)
    {
      const double room = inverse.reach[k] - std::fabs(middle[d]) - std::fabs(offset[d]);
      const double along = std::fabs(half[d]);
      axis = room > 0.0 ? std::min(axis, along > 0.0 ? room / along : kInfinity) : 0.0;
      if (!(room > 0.0))
      {
        break;
      }
    }
    if (!(axis > 1.0 + 1e-9))
    {
      continue;
    }
    axis = std::min(axis, 1e12) * (1.0 - 1e-12);
    const double rho = axis + std::sqrt(axis * axis - 1.0);
    least = std::min(least, 4.0 * bounds[k] * std::pow(rho, 1 - n) / (rho - 1.0));
  }
  return Above(least);
}

double ChebyshevLebesgue(int n)
{
  return 2.0 / std::numbers::pi * std::log(static_cast<double>(n)) + 1.0;
}
} // namespace pixelexact
