// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FacePlaces.h"

#include "Core/Basis/LineFunctions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelexact
{
namespace
{
/// Gauss points of a parameter beyond the order.
constexpr int kMoreGaussPoints = 2;

FacePlaces GaussPlaces(int corners, int count)
{
  const GaussRule rule = MakeGaussRule(count);
  FacePlaces places;
  for (std::size_t i = 0; i < rule.points.size(); ++i)
  {
    for (std::size_t j = 0; j < rule.points.size(); ++j)
    {
      const double shrink = corners == 3 ? 1.0 - rule.points[j] : 1.0;
      places.points.push_back({ rule.points[i] * shrink, rule.points[j] });
      places.weights.push_back(rule.weights[i] * rule.weights[j] * shrink);
    }
  }
  return places;
}

std::vector<FacePoint> ChebyshevPlaces(int corners, int count)
{
  std::vector<double> line;
  line.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    line.push_back(0.5 - 0.5 * std::cos((2 * k + 1) * std::numbers::pi / (2.0 * count)));
  }
  std::vector<FacePoint> points;
  for (const double first : line)
  {
    for (const double second : line)
    {
      points.push_back({ corners == 3 ? first * (1.0 - second) : first, second });
    }
  }
  return points;
}
} // namespace

GaussRule MakeGaussRule(int count)
{
  GaussRule rule;
  for (const long double z : GaussPoints(count))
  {
    long double before = 1.0L;
    long double now = z;
    for (int n = 2; n <= count; ++n)
    {
      const long double next =
        ((2.0L * n - 1.0L) * z * now - (n - 1.0L) * before) / static_cast<long double>(n);
      before = now;
      now = next;
    }
    const long double slope = count * (before - z * now) / (1.0L - z * z);
    rule.points.push_back(static_cast<double>((1.0L + z) / 2.0L));
    rule.weights.push_back(static_cast<double>(1.0L / ((1.0L - z * z) * slope * slope)));
  }
  return rule;
}

PlacesByOrder::PlacesByOrder(int highestGauss, int highestOrder)
{
  for (int corners = 3; corners <= 4; ++corners)
  {
    const auto kind = static_cast<std::size_t>(corners - 3);
    for (int n = 0; n <= highestGauss; ++n)
    {
      Gauss[kind].push_back(GaussPlaces(corners, n + kMoreGaussPoints));
    }
    for (int n = 0; n <= highestOrder; ++n)
    {
      Chebyshev[kind].push_back(ChebyshevPlaces(corners, kPointsPerDegree * std::max(n, 1)));
    }
  }
}
} // namespace pixelexact
