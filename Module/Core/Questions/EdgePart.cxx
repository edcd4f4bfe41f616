// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeBounds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace pixelexact
{
using namespace edges;

namespace
{
/// Of the sine of the angle between two sides of a triangle, squared: below, it is a line.
constexpr double kFlat = 1e-6;

/// A part of a plane as seen from a triangle's first corner: x = x0 + s (x1 - x0) + t (x2 - x0).
struct InTriangle
{
  std::array<double, Outline::kMostCorners> s{};
  std::array<double, Outline::kMostCorners> t{};
  double mostS = 0.0; ///< |s|
  double mostT = 0.0;
  double off = 0.0; ///< by what the part is off the plane
};

std::optional<InTriangle> Seen(
  const std::array<LocatedPoint, 3>& triangle, std::span<const Vec3> corners)
{
  const Vec3 u = triangle[1].x - triangle[0].x;
  const Vec3 v = triangle[2].x - triangle[0].x;
  const double uu = glm::dot(u, u);
  const double uv = glm::dot(u, v);
  const double vv = glm::dot(v, v);
  const double det = uu * vv - uv * uv;
  // Written so that a NaN is none.
  if (!(det > kFlat * uu * vv))
  {
    return std::nullopt;
  }
  InTriangle part;
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Vec3 x = corners[k] - triangle[0].x;
    const double xu = glm::dot(x, u);
    const double xv = glm::dot(x, v);
    const double s = (vv * xu - uv * xv) / det;
    const double t = (uu * xv - uv * xu) / det;
    part.s[k] = s;
    part.t[k] = t;
    part.mostS = std::max(part.mostS, std::fabs(s));
    part.mostT = std::max(part.mostT, std::fabs(t));
    const double terms = LargestOf(x) + std::fabs(s) * LargestOf(u) + std::fabs(t) * LargestOf(v);
    part.off = std::max(part.off, LargestOf(x - s * u - t * v) + kRoundoffs * terms);
  }
  return part;
}
} // namespace

std::optional<Interval> EdgeBounds::Over(
  const std::array<LocatedPoint, 3>& triangle, const WideOutline& part) const
{
  if (!Functions.IsKnown())
  {
    return std::nullopt;
  }
  const EdgeNode& node = Tree.LeafAt(triangle[0].eta);
  const auto corners = part.outline.Corners();
  const std::optional<InTriangle> seen =
    node.regular && node.wide.Holds(triangle[1].eta) && node.wide.Holds(triangle[2].eta)
    ? Seen(triangle, corners)
    : std::nullopt;
  if (!seen)
  {
    return std::nullopt;
  }

  const std::array<double, 3> shift = ShiftOf(node, triangle);
  // In xi, from the first corner; what is known of the corners adds up to `weight` times.
  const double weight = 1.0 + 2.0 * (seen->mostS + seen->mostT);
  const double inY = (part.slack + seen->off) / Functions.Size();
  const Vec3 sides[2] = { triangle[1].xi - triangle[0].xi, triangle[2].xi - triangle[0].xi };
  double along[2][3];
  double besides[3];
  double way[3] = {};
  double off[3];
  double beside[3];
  std::array<Vec3, Outline::kMostCorners> places;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vec3 step = seen->s[i] * sides[0] + seen->t[i] * sides[1];
    places[i] = triangle[0].xi + step;
    for (std::size_t k = 0; k < 3; ++k)
    {
      way[k] = std::max(way[k], std::fabs(step[static_cast<int>(k)]));
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int d = static_cast<int>(k);
    along[0][k] = std::fabs(sides[0][d]) + 2.0 * shift[k];
    along[1][k] = std::fabs(sides[1][d]) + 2.0 * shift[k];
    way[k] += weight * shift[k];
    besides[k] = weight * shift[k] + node.lean[k] * inY;
    beside[k] = kBeside + 2.0 * shift[k];
  }
  // Half of what a form is on the way there, and on the two sides.
  const auto halfOf = [&](const double(&form)[6], const double(&there)[3])
  {
    return 0.5 *
      (Quadratic(form, there) + seen->mostS * Quadratic(form, along[0]) +
        seen->mostT * Quadratic(form, along[1]));
  };
  for (std::size_t k = 0; k < 3; ++k)
  {
    off[k] = (halfOf(node.bend[k], way) + besides[k]) * kUp;
  }
  for (const EdgeNodeEnd& end : node.wideEnds)
  {
    const double less = end.Across(off) - (end.ofElement ? end.Across(beside) : 0.0);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      // Written so that a NaN is not covered.
      if (!(end.DepthOf(places[i]) >= less))
      {
        return std::nullopt;
      }
    }
  }

  double error = node.valueError;
  double most = 0.0;
  double change = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    way[k] = (way[k] + off[k]) * kUp;
    error += node.slope[k] * shift[k];
    most += node.slope[k] * (besides[k] + 2.0 * beside[k]);
    change += node.slope[k] * std::max({ way[k], along[0][k], along[1][k] });
  }
  const double first = triangle[0].value;
  const double rises[2] = { triangle[1].value - first, triangle[2].value - first };
  Interval linear(first);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const double value = first + seen->s[i] * rises[0] + seen->t[i] * rises[1];
    linear = i == 0 ? Interval(value) : Join(linear, Interval(value));
  }
  most += halfOf(node.curve, way) + weight * error;
  if (Functions.Components() > 1)
  {
    // The norm of a vector that changes by at most `change`; see Along.
    change += 2.0 * error;
    const double least = first - change;
    if (!(least > 0.25 * change))
    {
      return std::nullopt;
    }
    most += 0.5 * (1.0 + seen->mostS + seen->mostT) * change * change / least;
  }
  most = most * kUp + kRoundoffs * weight * (std::fabs(linear.lower) + std::fabs(linear.upper));
  return Interval(rounding::Below(linear.lower - most), rounding::Above(linear.upper + most));
}
} // namespace pixelexact
