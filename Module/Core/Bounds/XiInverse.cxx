// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bounds/XiInverse.h"

#include "Core/Base/MadeOnDemand.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace pixelexact
{
namespace
{
/// Covers the rounding of sums of positive numbers, and of powers.
constexpr double kSumUp = 1.0 + 1e-9;

/// The magnitudes |T_n(i R)|, which bound T_n on the disc, and their derivatives by R.
struct DiscPowers
{
  std::vector<double> value;
  std::vector<double> slope;

  DiscPowers(int degree, double radius)
    : value(static_cast<std::size_t>(std::max(degree, 1)) + 1, 1.0)
    , slope(value.size(), 0.0)
  {
    value[1] = radius;
    slope[1] = 1.0;
    for (std::size_t n = 2; n < value.size(); ++n)
    {
      value[n] = (2.0 * radius * value[n - 1] + value[n - 2]) * kSumUp;
      slope[n] = (2.0 * value[n - 1] + 2.0 * radius * slope[n - 1] + slope[n - 2]) * kSumUp;
    }
  }
};

std::array<DiscPowers, 3> PowersOf(const std::array<int, 3>& degree, double radius)
{
  return { DiscPowers(degree[0], radius), DiscPowers(degree[1], radius),
    DiscPowers(degree[2], radius) };
}

/// Calls visit(i, j, k, index).
template <class Visit>
void ForEachIndex(const std::array<int, 3>& degree, const Visit& visit)
{
  std::size_t index = 0;
  for (int i = 0; i <= degree[0]; ++i)
  {
    for (int j = 0; j <= degree[1]; ++j)
    {
      for (int k = 0; k <= degree[2]; ++k)
      {
        visit(static_cast<std::size_t>(i), static_cast<std::size_t>(j), static_cast<std::size_t>(k),
          index++);
      }
    }
  }
}

//--- Rounding of the kernels ---

/// Bounds |t^n P_n^{(a,0)}(y / t)| of |y| <= largest y, |t| <= largest t, by the recurrence with
/// magnitudes.
std::vector<double> JacobiMajorant(int a, int degree, double y, double t)
{
  std::vector<double> bound(static_cast<std::size_t>(degree) + 1, 1.0);
  if (degree > 0)
  {
    bound[1] = 0.5 * ((a + 2) * y + a * t);
  }
  for (int n = 1; n < degree; ++n)
  {
    const double m = 2.0 * n + a;
    const double scale = 2.0 * (n + 1.0) * (n + a + 1.0) * m;
    const auto at = static_cast<std::size_t>(n);
    bound[at + 1] = ((m + 1.0) * ((m + 2.0) * m * y + static_cast<double>(a) * a * t) * bound[at] +
                      2.0 * (n + a) * n * (m + 2.0) * t * t * bound[at - 1]) /
      scale * kSumUp;
  }
  return bound;
}

/// The largest |P_n| on [-y, y], y >= 1: P_n(y).
std::vector<double> LegendreBounds(int degree, double y)
{
  std::vector<double> bound(static_cast<std::size_t>(degree) + 1, 1.0);
  for (int n = 0; n < degree; ++n)
  {
    const auto at = static_cast<std::size_t>(n);
    const double before = n > 0 ? bound[at - 1] : 0.0;
    bound[at + 1] = ((2.0 * n + 1.0) * y * bound[at] - n * before) / (n + 1.0) * kSumUp;
  }
  return bound;
}

double Largest(double lower, double upper)
{
  return std::max(std::fabs(lower), std::fabs(upper));
}

/// Bounds of the modes over a box of xi, also outside the shape.
class ModeMajorant
{
public:
  ModeMajorant(const Space& space, const Box3& box)
    : Shaped(space.shape)
  {
    const auto [p, q, r] = space.order;
    const Vec3& a = box.lower;
    const Vec3& b = box.upper;
    const auto largest = [&](int d) { return std::max(1.0, Largest(a[d], b[d])); };
    if (Shaped == Shape::Hexahedron)
    {
      First = LegendreBounds(p, largest(0));
      Second = { LegendreBounds(q, largest(1)) };
      Third = { LegendreBounds(r, largest(2)) };
      return;
    }
    // h = (1 - xi_3) / 2 and the numerators 1 + xi_d - h, all linear in xi.
    const double h = Largest(0.5 * (1.0 - a[2]), 0.5 * (1.0 - b[2]));
    if (Shaped == Shape::Prism)
    {
      const double y = Largest(0.5 + a[0] + 0.5 * a[2], 0.5 + b[0] + 0.5 * b[2]);
      First = JacobiMajorant(0, p, y, h);
      Second = { LegendreBounds(q, largest(1)) };
      for (int n = 0; n <= p; ++n)
      {
        Third.push_back(JacobiMajorant(2 * n + 1, r, largest(2), 1.0));
      }
      return;
    }
    const double t1 = Largest(-0.5 * (a[1] + a[2]), -0.5 * (b[1] + b[2]));
    const double y1 = Largest(1.0 + a[0] + 0.5 * (a[1] + a[2]), 1.0 + b[0] + 0.5 * (b[1] + b[2]));
    const double y2 = Largest(0.5 + a[1] + 0.5 * a[2], 0.5 + b[1] + 0.5 * b[2]);
    First = JacobiMajorant(0, p, y1, t1);
    for (int n = 0; n <= p; ++n)
    {
      Second.push_back(JacobiMajorant(2 * n + 1, q, y2, h));
    }
    for (int n = 0; n <= q; ++n)
    {
      Third.push_back(JacobiMajorant(2 * n + 2, r, largest(2), 1.0));
    }
  }

  [[nodiscard]] double Of(int p, int q, int r) const
  {
    const auto at = [](int n) { return static_cast<std::size_t>(n); };
    const auto row = [&](const std::vector<std::vector<double>>& rows, int n) -> const auto&
    {
      return rows[std::min(at(n), rows.size() - 1)];
    };
    const int third = Shaped == Shape::Tetrahedron ? p + q : p;
    return First[at(p)] * row(Second, p)[at(q)] * row(Third, third)[at(r)];
  }

private:
  Shape Shaped;
  std::vector<double> First;
  std::vector<std::vector<double>> Second;
  std::vector<std::vector<double>> Third;
};

/// How far a kernel's value may be off in a box, per unit of the sum of |c| |mode|: the number of
/// successive operations of recurrences and sums, as in ElementBounds.
double KernelNoise(const Space& space, const ModeMajorant& majorant, const double* coefficients)
{
  double sum = 0.0;
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    { sum += std::fabs(coefficients[mode]) * majorant.Of(p, q, r); });
  const int steps = space.order[0] + space.order[1] + space.order[2];
  return Gamma(10 * (steps + 6)) * sum * kSumUp;
}

//--- Values in Chebyshev's points, and back ---

std::vector<double> PointsOf(int degree)
{
  const int n = degree + 1;
  std::vector<double> points(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i)
  {
    points[static_cast<std::size_t>(i)] = std::cos(std::numbers::pi * (2 * i + 1) / (2.0 * n));
  }
  return points;
}

/// Row k gives the coefficient of T_k of values in n points.
const std::vector<double>& TransformMatrix(std::size_t n)
{
  static const MadeOnDemand<std::vector<double>> kept(kMaxOrder + 2);
  return kept.Get(n,
    [n]
    {
      std::vector<double> matrix(n * n);
      for (std::size_t k = 0; k < n; ++k)
      {
        for (std::size_t i = 0; i < n; ++i)
        {
          matrix[k * n + i] = (k == 0 ? 1.0 : 2.0) / static_cast<double>(n) *
            std::cos(std::numbers::pi * static_cast<double>(k * (2 * i + 1)) /
              (2.0 * static_cast<double>(n)));
        }
      }
      return std::make_unique<const std::vector<double>>(std::move(matrix));
    });
}

/// Turns values in Chebyshev's points along one direction into coefficients.
void Transform(std::vector<double>& values, int degree, std::size_t stride)
{
  const auto n = static_cast<std::size_t>(degree) + 1;
  if (n == 1)
  {
    return;
  }
  const std::vector<double>& matrix = TransformMatrix(n);
  std::vector<double> line(n);
  for (std::size_t block = 0; block < values.size(); block += n * stride)
  {
    for (std::size_t first = block; first < block + stride; ++first)
    {
      for (std::size_t k = 0; k < n; ++k)
      {
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i)
        {
          sum += matrix[k * n + i] * values[first + i * stride];
        }
        line[k] = sum;
      }
      for (std::size_t k = 0; k < n; ++k)
      {
        values[first + k * stride] = line[k];
      }
    }
  }
}

std::array<int, 3> DegreeInXi(const Space& space)
{
  return { space.order[0], space.order[1], space.order[2] };
}
} // namespace

double ChebyshevLebesgue(int n)
{
  return 2.0 / std::numbers::pi * std::log(static_cast<double>(n)) + 1.0;
}

DiscBounds BoxSeries::OverDiscs(std::size_t component) const
{
  DiscBounds bounds{};
  for (std::size_t disc = 0; disc < bounds.size(); ++disc)
  {
    const auto powers = PowersOf(degree, kDiscRadii[disc]);
    double sum = 0.0;
    ForEachIndex(degree,
      [&](std::size_t i, std::size_t j, std::size_t k, std::size_t index)
      {
        sum += index == 0 ? 0.0
                          : std::fabs(coefficients[component][index]) * powers[0].value[i] *
            powers[1].value[j] * powers[2].value[k];
      });
    bounds[disc] = sum * kSumUp;
  }
  return bounds;
}

double GrowthOutside(const std::array<int, 3>& degree, const Vec3& reach)
{
  // A polynomial of degree n that is at most 1 on [-1,1] is at most (x + sqrt(x^2 - 1))^n at x.
  double growth = 1.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const double x = std::max(1.0, reach[static_cast<int>(d)]);
    growth *= std::pow(x + std::sqrt(x * x - 1.0), degree[d]);
  }
  return growth * kSumUp;
}

BoxSeries MakeBoxSeries(
  const Space& space, const double* coefficients, int components, const Box3& box)
{
  BoxSeries series;
  series.degree = DegreeInXi(space);
  const Vec3 centre = 0.5 * (box.lower + box.upper);
  const Vec3 half = 0.5 * (box.upper - box.lower);
  std::array<std::vector<double>, 3> points;
  for (std::size_t d = 0; d < 3; ++d)
  {
    points[d] = PointsOf(series.degree[d]);
  }
  std::vector<Vec3> xi(points[0].size() * points[1].size() * points[2].size());
  ForEachIndex(series.degree,
    [&](std::size_t i, std::size_t j, std::size_t k, std::size_t index)
    { xi[index] = centre + half * Vec3(points[0][i], points[1][j], points[2][k]); });
  const LaneBuffer lanes(xi);
  const auto padded = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  std::vector<double> values(padded * static_cast<std::size_t>(components));
  std::vector<double*> out(static_cast<std::size_t>(components));
  for (std::size_t c = 0; c < out.size(); ++c)
  {
    out[c] = values.data() + c * padded;
  }
  KernelsFor(space).value(space, coefficients, components, lanes.View(), out.data());
  const bool isPolynomial = space.shape != Shape::Pyramid;
  const ModeMajorant majorant(isPolynomial ? space : Space{}, box);
  const auto modes = static_cast<std::size_t>(space.Modes());
  double lebesgue = 1.0;
  for (const int degree : series.degree)
  {
    lebesgue *= ChebyshevLebesgue(degree + 1);
  }
  for (std::size_t c = 0; c < out.size(); ++c)
  {
    std::vector<double> one(out[c], out[c] + xi.size());
    double largest = 0.0;
    for (const double value : one)
    {
      largest = std::max(largest, std::fabs(value));
    }
    const auto q = points[1].size();
    const auto r = points[2].size();
    Transform(one, series.degree[0], q * r);
    Transform(one, series.degree[1], r);
    Transform(one, series.degree[2], 1);
    const int terms = series.degree[0] + series.degree[1] + series.degree[2] + 3;
    // Each coefficient is a sum of `largest` times weights whose magnitudes sum up to at most 8.
    const double rounding = Gamma(2 * terms + 24) * 8.0 * largest * static_cast<double>(one.size());
    const double noise =
      isPolynomial ? KernelNoise(space, majorant, coefficients + c * modes) : kInfinity;
    series.noise.push_back(noise);
    series.error.push_back((noise * lebesgue + rounding) * kSumUp);
    series.coefficients.push_back(std::move(one));
  }
  return series;
}

//--- The inverse ---

Vec3 XiInverse::Apply(const Vec3& v) const
{
  const auto& a = inverse;
  return { a[0] * v.x + a[1] * v.y + a[2] * v.z, a[3] * v.x + a[4] * v.y + a[5] * v.z,
    a[6] * v.x + a[7] * v.y + a[8] * v.z };
}

bool XiInverse::IsProven() const
{
  return std::ranges::any_of(reach, [](double r) { return r > 1.0; });
}

double XiInverse::Norm() const
{
  double norm = 0.0;
  for (std::size_t row = 0; row < 9; row += 3)
  {
    norm = std::max(
      norm, std::fabs(inverse[row]) + std::fabs(inverse[row + 1]) + std::fabs(inverse[row + 2]));
  }
  return norm * kSumUp;
}

XiInverse::Slope XiInverse::SlopeAt(double r, double change) const
{
  // Cauchy's estimate on the complex line through z along the change: |s| <= R up to reach - r. The
  // polydisc must hold the box, so that no other s of the box belongs to z.
  Slope best{ kInfinity, -1 };
  for (std::size_t disc = 1; disc < reach.size(); ++disc)
  {
    const double room = reach[disc] - r - change;
    const double factor = room > 0.0 ? kDiscRadii[disc] / room * kSumUp : kInfinity;
    if (factor < best.factor)
    {
      best = { factor, static_cast<int>(disc) };
    }
  }
  return best;
}

namespace
{
/// Row-major inverse; false where there is none.
bool Invert(const std::array<double, 9>& a, std::array<double, 9>& out)
{
  out = { a[4] * a[8] - a[5] * a[7], a[2] * a[7] - a[1] * a[8], a[1] * a[5] - a[2] * a[4],
    a[5] * a[6] - a[3] * a[8], a[0] * a[8] - a[2] * a[6], a[2] * a[3] - a[0] * a[5],
    a[3] * a[7] - a[4] * a[6], a[1] * a[6] - a[0] * a[7], a[0] * a[4] - a[1] * a[3] };
  const double determinant = a[0] * out[0] + a[1] * out[3] + a[2] * out[6];
  bool isFinite = determinant != 0.0;
  for (double& entry : out)
  {
    entry /= determinant;
    isFinite = isFinite && std::isfinite(entry);
  }
  return isFinite;
}

/// Index of the coefficient of degree 1 in one direction; none where the degree is 0.
std::size_t LinearIndex(const std::array<int, 3>& degree, std::size_t direction)
{
  const auto r = static_cast<std::size_t>(degree[2]) + 1;
  const auto q = static_cast<std::size_t>(degree[1]) + 1;
  return direction == 0 ? q * r : (direction == 1 ? r : 1);
}

/// Coefficients of N, with bounds of their rounding: N = A^-1 Phi - a_0 - s.
struct Deviation
{
  std::array<std::vector<double>, 3> size; ///< |coefficient|, from above

  Deviation(const BoxSeries& phi, const std::array<double, 9>& inverse)
  {
    const std::size_t count = phi.coefficients[0].size();
    for (std::size_t row = 0; row < 3; ++row)
    {
      size[row].assign(count, 0.0);
      for (std::size_t index = 1; index < count; ++index)
      {
        double sum = 0.0;
        double magnitude = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
        {
          const double term = inverse[3 * row + c] * phi.coefficients[c][index];
          sum += term;
          magnitude += std::fabs(term);
        }
        if (index == LinearIndex(phi.degree, row))
        {
          sum -= 1.0;
          magnitude += 1.0;
        }
        size[row][index] = std::fabs(sum) + Gamma(5) * magnitude;
      }
    }
  }
};

/// R minus the largest |N| where N's Lipschitz constant is below 1, else 0.
double ReachOf(const BoxSeries& phi, const Deviation& deviation, double radius)
{
  const auto powers = PowersOf(phi.degree, radius);
  double largest = 0.0;
  double lipschitz = 0.0;
  for (std::size_t row = 0; row < 3; ++row)
  {
    double value = 0.0;
    double slope = 0.0;
    ForEachIndex(phi.degree,
      [&](std::size_t i, std::size_t j, std::size_t k, std::size_t index)
      {
        const double a = deviation.size[row][index];
        const double x = powers[0].value[i];
        const double y = powers[1].value[j];
        const double z = powers[2].value[k];
        value += a * x * y * z;
        slope += a *
          (powers[0].slope[i] * y * z + x * powers[1].slope[j] * z + x * y * powers[2].slope[k]);
      });
    largest = std::max(largest, value * kSumUp);
    lipschitz = std::max(lipschitz, slope * kSumUp);
  }
  return lipschitz < 1.0 ? radius - largest : 0.0;
}
} // namespace

XiInverse MakeXiInverse(const Mesh& mesh, int element, const BoxSeries& phi, const Box3& box)
{
  XiInverse made;
  made.box = box;
  made.centre = 0.5 * (box.lower + box.upper);
  made.halfWidth = 0.5 * (box.upper - box.lower);
  made.degree = phi.degree;
  std::array<double, 9> linear{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    made.origin[c] = phi.coefficients[c][0];
    for (std::size_t d = 0; d < 3; ++d)
    {
      linear[3 * c + d] = phi.degree[d] > 0 ? phi.coefficients[c][LinearIndex(phi.degree, d)] : 0.0;
    }
  }
  if (!Invert(linear, made.inverse))
  {
    made.inverse = {};
    made.slack = kInfinity;
    made.deviation = Vec3(kInfinity);
    return made;
  }
  const Deviation deviation(phi, made.inverse);
  double error = 0.0;
  double size = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    error = std::max(error, phi.error[c] + phi.noise[c]);
    size += std::fabs(made.origin[c]);
  }
  const double uncertain = mesh.uncertainty.empty()
    ? 0.0
    : mesh.uncertainty[static_cast<std::size_t>(element)] / mesh.size[element];
  made.slack =
    made.Norm() * (error + uncertain + Gamma(8) * (size + 8.0)) * kSumUp + Gamma(8) * 8.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    double sum = 0.0;
    for (const double a : deviation.size[d])
    {
      sum += a;
    }
    made.deviation[static_cast<int>(d)] = sum * kSumUp;
  }
  // The polydisc must hold the box. If one is not proven, no larger one is.
  for (std::size_t disc = 1; disc < made.reach.size() && std::isfinite(made.slack); ++disc)
  {
    made.reach[disc] = ReachOf(phi, deviation, kDiscRadii[disc]);
    if (!(made.reach[disc] > 0.0))
    {
      break;
    }
  }
  return made;
}

RayEllipses::RayEllipses(const XiInverse& inverse, const Vec3& middle, const Vec3& half)
{
  for (std::size_t disc = 0; disc < rho_.size(); ++disc)
  {
    if (!(inverse.reach[disc] > 0.0))
    {
      continue;
    }
    // The ellipse's image stays within |middle| + |half| (rho + 1 / rho) / 2.
    double q = 1e6;
    for (int d = 0; d < 3; ++d)
    {
      const double room = inverse.reach[disc] - std::fabs(middle[d]);
      q = half[d] != 0.0 ? std::min(q, room / std::fabs(half[d])) : (room > 0.0 ? q : 0.0);
    }
    if (q > 1.0)
    {
      q *= 1.0 - 1e-9;
      rho_[disc] = q > 1.0 ? q + std::sqrt(q * q - 1.0) : 0.0;
    }
  }
}

double RayEllipses::Error(const DiscBounds& bounds, int n) const
{
  double best = kInfinity;
  for (std::size_t disc = 0; disc < bounds.size(); ++disc)
  {
    if (rho_[disc] > 1.0)
    {
      best = std::min(
        best, 4.0 * bounds[disc] * std::pow(rho_[disc], 1 - n) / (rho_[disc] - 1.0) * kSumUp);
    }
  }
  return best;
}

int RayEllipses::PointsFor(const DiscBounds& bounds, double tolerance) const
{
  double fewest = kMaxRayPoints;
  for (std::size_t disc = 0; disc < bounds.size(); ++disc)
  {
    if (rho_[disc] > 1.0 && std::isfinite(bounds[disc]))
    {
      const double ratio = 4.0 * bounds[disc] / ((rho_[disc] - 1.0) * tolerance);
      fewest = std::min(fewest, ratio > 1.0 ? 1.0 + std::log(ratio) / std::log(rho_[disc]) : 1.0);
    }
  }
  return static_cast<int>(std::ceil(fewest));
}
} // namespace pixelexact
