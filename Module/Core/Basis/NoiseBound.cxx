// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Basis/NoiseBound.h"

#include "Core/Shape/Shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

// Let p be the function that noise of one unit makes, of any signs: a polynomial of degree n in
// each eta. On m > n of Chebyshev's points along a line it is, somewhere, at least cos(pi n / 2m)
// times the largest that it is on the line (Ehlich and Zeller, Schwankung von Polynomen zwischen
// Gitterpunkten, 1964); on their grid therefore the product of three such factors.
namespace pixelexact
{
namespace
{
/// Points along a line for each degree.
constexpr int kDensity = 3;
constexpr double kMostProducts = 2e8;
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
} // namespace

double NoiseBound(const ChangeOfBasis& change)
{
  const Space& space = change.Target();
  const auto modes = static_cast<std::size_t>(space.Modes());
  const auto sources = static_cast<std::size_t>(change.SourceSize());
  std::array<std::vector<double>, 3> lines;
  double places = 1.0;
  double factor = 1.0;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int degree = space.TensorDegree()[d];
    lines[d] = PointsFor(degree);
    places *= static_cast<double>(lines[d].size());
    factor /= degree > 0 ? std::cos(std::numbers::pi / (2.0 * kDensity)) : 1.0;
  }
  if (places * static_cast<double>(modes) * static_cast<double>(sources) > kMostProducts)
  {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<double> columns(sources * modes);
  std::vector<double> unit(sources, 0.0);
  for (std::size_t s = 0; s < sources; ++s)
  {
    unit[s] = 1.0;
    change.Apply(unit, 0.0, std::span(columns).subspan(s * modes, modes));
    unit[s] = 0.0;
  }
  std::vector<long double> values(modes);
  std::vector<double> rounded(modes);
  double most = 0.0;
  for (const double x : lines[0])
  {
    for (const double y : lines[1])
    {
      for (const double z : lines[2])
      {
        const Vec3 xi = TensorToReference(space.shape, { x, y, z });
        EvaluateModes(space, { xi.x, xi.y, xi.z }, values.data());
        std::ranges::transform(
          values, rounded.begin(), [](long double v) { return static_cast<double>(v); });
        double sum = 0.0;
        for (std::size_t s = 0; s < sources; ++s)
        {
          sum += std::fabs(std::inner_product(
            rounded.begin(), rounded.end(), columns.begin() + std::ptrdiff_t(s * modes), 0.0));
        }
        most = std::max(most, sum);
      }
    }
  }
  return most * factor * kUp;
}
} // namespace pixelexact
