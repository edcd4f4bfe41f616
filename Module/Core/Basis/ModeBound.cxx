// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/ModeBound.h"

#include "Core/Math/Rounding.h"
#include "Core/Shape/Shape.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pixelexact
{
namespace
{
double Binomial(int n, int k)
{
  double result = 1.0;
  for (int i = 1; i <= k; ++i)
  {
    result = result * (n - k + i) / i;
  }
  return result;
}

} // namespace

double ModeBound(const Space& space, int p, int q, int r)
{
  // With h = (1 - z) / 2 and P = P_r^{(a,0)}: |P| <= C(r + a, r) (Szego, Orthogonal Polynomials,
  // theorem 7.32.1), and h^{a/2} |P| <= 1, for h^{a/2} P is an element of a unitary matrix
  // (Wigner's d). A factor h^n P with n <= a / 2 is therefore at most min(C h^n, h^{n - a/2}),
  // whose peak is C^{1 - 2 n / a}: an n-th power against one of n - a/2.
  const auto factor = [](int n, int a, int degree)
  { return a == 0 ? 1.0 : std::pow(Binomial(degree + a, degree), 1.0 - 2.0 * n / a); };
  switch (space.shape)
  {
    case Shape::Prism:
      return factor(p, 2 * p + 1, r);
    case Shape::Tetrahedron:
      return factor(p, 2 * p + 1, q) * factor(p + q, 2 * (p + q) + 2, r);
    case Shape::Pyramid:
    {
      const int m = std::max(p, q);
      return space.form == Form::Tensor ? 1.0 : factor(m, 2 * m + 2, r);
    }
    default:
      return 1.0;
  }
}

double SumOfModeBounds(const Space& space)
{
  double sum = 0.0;
  ForEachMode(space, [&](int p, int q, int r, int /*mode*/) { sum += ModeBound(space, p, q, r); });
  return sum;
}

namespace
{
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Points along a line for each degree.
constexpr int kDensity = 3;
constexpr double kMaxProducts = 2e8;
/// Covers the rounding of sums and of eta.
constexpr double kUp = 1.0 + 1e-6;

std::vector<double> PointsFor(int degree)
{
  std::vector<double> points(static_cast<std::size_t>(std::max(1, kDensity * degree)));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    points[k] = std::cos(std::numbers::pi * (2.0 * static_cast<double>(k) + 1.0) /
      (2.0 * static_cast<double>(points.size())));
  }
  return points;
}

/// The largest sum of the sizes of a factor's source functions.
double BoundOf(const BasisFactor& factor)
{
  const Space& space = factor.space;
  std::array<std::vector<double>, 3> lines;
  std::size_t places = 1;
  double between = 1.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int degree = space.TensorDegree()[d];
    lines[d] = PointsFor(degree);
    places *= lines[d].size();
    between /= degree > 0 ? std::cos(std::numbers::pi / (2.0 * kDensity)) : 1.0;
  }
  if (static_cast<double>(places) * factor.rows * factor.columns > kMaxProducts)
  {
    return std::numeric_limits<double>::infinity();
  }
  Matrix modes(places, factor.rows);
  std::vector<long double> values(static_cast<std::size_t>(factor.rows));
  Eigen::Index place = 0;
  for (const double x : lines[0])
  {
    for (const double y : lines[1])
    {
      for (const double z : lines[2])
      {
        const Vec3 xi = TensorToReference(space.shape, { x, y, z });
        EvaluateModes(space, { xi.x, xi.y, xi.z }, values.data());
        for (int mode = 0; mode < factor.rows; ++mode)
        {
          modes(place, mode) = static_cast<double>(values[static_cast<std::size_t>(mode)]);
        }
        ++place;
      }
    }
  }
  Matrix sources(factor.rows, factor.columns);
  std::ranges::transform(factor.matrix, sources.data(),
    [](long double element) { return static_cast<double>(element); });
  return (modes * sources).cwiseAbs().rowwise().sum().maxCoeff() * between;
}
} // namespace

double NoiseBound(const ChangeOfBasis& change)
{
  double bound = kUp;
  for (const BasisFactor& factor : change.GetFactors())
  {
    bound *= BoundOf(factor);
  }
  return bound;
}

MapNoise::MapNoise(const ChangeOfBasis& change)
  : OfMap(NoiseBound(change))
{
  const Space& space = change.Target();
  Bounds.resize(static_cast<std::size_t>(space.Modes()));
  ForEachMode(space,
    [&](int p, int q, int r, int mode)
    {
      Bounds[static_cast<std::size_t>(mode)] = ModeBound(space, p, q, r);
      OfModes += change.Amplification()[mode] * Bounds[static_cast<std::size_t>(mode)];
    });
}

double MapNoise::Of(double roundings, std::span<const double> modes) const
{
  double largest = 0.0;
  for (std::size_t first = 0; first < modes.size(); first += Bounds.size())
  {
    double sum = 0.0;
    for (std::size_t mode = 0; mode < Bounds.size(); ++mode)
    {
      sum += std::fabs(modes[first + mode]) * Bounds[mode];
    }
    largest = std::max(largest, sum);
  }
  return std::min(roundings * OfModes, roundings * OfMap + kUnitRoundoff * largest);
}
} // namespace pixelexact
