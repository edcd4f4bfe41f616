// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeBounds.h"
#include "Core/Questions/LocalCurves.h"

#include <glm/common.hpp>
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
/// A triangle is a line if the squared sine of the angle between two sides is below this.
constexpr double kFlat = 1e-6;
/// Smaller nodes are visited where `loose` exceeds this fraction of the width of the bounds.
constexpr double kLooseOfPart = 0.5;

/// A part of a plane in coordinates of a triangle: x = x0 + s (x1 - x0) + t (x2 - x0).
struct InTriangle
{
  std::array<double, Outline::kMaxCorners> s{};
  std::array<double, Outline::kMaxCorners> t{};
  double mostS = 0.0; ///< |s|
  double mostT = 0.0;
  double bentS = 0.0; ///< |s^2 - s|
  double bentT = 0.0;
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
  // The comparison is written so that a NaN gives no coordinates.
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
  const auto bent = [&](const auto& all)
  {
    const auto [least, most] = std::minmax_element(all.begin(), all.begin() + std::ssize(corners));
    return std::max({ std::fabs(*least * (*least - 1.0)), std::fabs(*most * (*most - 1.0)),
      *least < 0.5 && *most > 0.5 ? 0.25 : 0.0 });
  };
  part.bentS = bent(part.s);
  part.bentT = bent(part.t);
  return part;
}

/// The affine function with the values of a triangle's corners. Its error is the largest
/// difference, on the part, from first + s rises + t rises, including rounding.
void FitPlane(const std::array<LocatedPoint, 3>& triangle, const InTriangle& seen,
  const WideOutline& part, PlanarValues& found)
{
  const Vec3 u = triangle[1].x - triangle[0].x;
  const Vec3 v = triangle[2].x - triangle[0].x;
  const double rises[2] = { triangle[1].value - triangle[0].value,
    triangle[2].value - triangle[0].value };
  const double uu = glm::dot(u, u);
  const double uv = glm::dot(u, v);
  const double vv = glm::dot(v, v);
  found.origin = triangle[0].x;
  found.first = triangle[0].value;
  found.slope = ((rises[0] * vv - rises[1] * uv) * u + (rises[1] * uu - rises[0] * uv) * v) /
    (uu * vv - uv * uv);
  // Both functions are affine, so that their difference is largest at a corner. It includes all
  // rounding above.
  double most = 0.0;
  Vec3 farthest(part.slack);
  const auto corners = part.outline.Corners();
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const double value = found.first + seen.s[k] * rises[0] + seen.t[k] * rises[1];
    most = std::max(most,
      std::fabs(found.At(corners[k]) - value) +
        kRoundoffs * (std::fabs(seen.s[k] * rises[0]) + std::fabs(seen.t[k] * rises[1])));
    farthest = glm::max(farthest, glm::abs(corners[k] - found.origin) + part.slack);
  }
  found.error = most + glm::dot(glm::abs(found.slope), Vec3(part.slack) + kRoundoffs * farthest) +
    kRoundoffs * std::fabs(found.first);
}

/// The sides of a triangle, and the way from its first corner to a part, in xi: bounds, and their
/// errors.
struct Ways
{
  double side[2][3];  ///< between the points as they are known
  double along[2][3]; ///< |side|, and what it may be off
  double way[3];
  double unsure[3]; ///< of the sides
  double unsureOfWay[3];
};

/// Bounds a remainder b(w, w) / 2 of second order at s d_1 + t d_2, minus s times that at d_1 and t
/// times that at d_2. The form b differs from `form` by at most `beside`.
double BentBetween(
  const InTriangle& part, const Ways& ways, const double (&form)[6], const double (&beside)[6])
{
  const double known = part.bentS * std::fabs(Quadratic(form, ways.side[0])) +
    2.0 * part.mostS * part.mostT * std::fabs(Bilinear(form, ways.side[0], ways.side[1])) +
    part.bentT * std::fabs(Quadratic(form, ways.side[1]));
  double all[6];
  double rounding[6];
  for (std::size_t p = 0; p < 6; ++p)
  {
    all[p] = std::fabs(form[p]);
    rounding[p] = beside[p] + kRoundoffs * all[p];
  }
  const double unknown = Quadratic(rounding, ways.way) +
    part.mostS * Quadratic(rounding, ways.along[0]) +
    part.mostT * Quadratic(rounding, ways.along[1]);
  const double moved = Bilinear(all, ways.way, ways.unsureOfWay) +
    part.mostS * Bilinear(all, ways.along[0], ways.unsure) +
    part.mostT * Bilinear(all, ways.along[1], ways.unsure);
  return (0.5 * (known + unknown) + moved) * kUp;
}

std::array<double, 3> Farthest(const Ways& ways)
{
  std::array<double, 3> farthest;
  for (std::size_t k = 0; k < 3; ++k)
  {
    farthest[k] = std::max({ ways.way[k], ways.along[0][k], ways.along[1][k] });
  }
  return farthest;
}
} // namespace

std::optional<PlanarValues> EdgeBounds::Over(const std::array<LocatedPoint, 3>& triangle,
  const WideOutline& part, const ValueSet& wanted, EdgeWork* work) const
{
  if (!Functions.IsKnown())
  {
    return std::nullopt;
  }
  const EdgeNode* node = &Tree.LeafAt(triangle[0].eta, work);
  std::optional<PlanarValues> found = OverIn(*node, triangle, part, wanted);
  const std::array etas{ triangle[0].eta, triangle[1].eta, triangle[2].eta };
  while (found && found->loose > kLooseOfPart * found->values.Width() &&
    wanted.Meets(found->values.lower, found->values.upper))
  {
    node = Tree.SmallerWith(*node, etas, work);
    std::optional<PlanarValues> smaller =
      node != nullptr ? OverIn(*node, triangle, part, wanted) : std::nullopt;
    if (!smaller)
    {
      break;
    }
    found = smaller;
  }
  return found;
}

std::optional<PlanarValues> EdgeBounds::OverIn(const EdgeNode& node,
  const std::array<LocatedPoint, 3>& triangle, const WideOutline& part,
  const ValueSet& wanted) const
{
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
  // In xi, from the first corner. The errors of the corners add up to `weight` times one of them.
  const double weight = 1.0 + 2.0 * (seen->mostS + seen->mostT);
  const double inY = (part.slack + seen->off) / Functions.Size();
  const Vec3 sides[2] = { triangle[1].xi - triangle[0].xi, triangle[2].xi - triangle[0].xi };
  Ways ways{};
  auto& [side, along, way, unsure, unsureOfWay] = ways;
  double besides[3];
  double off[3];
  double beside[3];
  std::array<Vec3, Outline::kMaxCorners> places;
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
    unsure[k] = 2.0 * shift[k];
    unsureOfWay[k] = weight * shift[k];
    for (std::size_t i = 0; i < 2; ++i)
    {
      side[i][k] = sides[i][d];
      along[i][k] = std::fabs(sides[i][d]) + unsure[k];
    }
    way[k] += unsureOfWay[k];
    besides[k] = weight * shift[k] + node.lean[k] * inY;
    beside[k] = kBeside + 2.0 * shift[k];
  }
  // Half of the form on the way to the part, and on the two sides.
  const auto halfOf = [&seen, &along = ways.along](const double(&form)[6], const double(&there)[3])
  {
    return 0.5 *
      (Quadratic(form, there) + seen->mostS * Quadratic(form, along[0]) +
        seen->mostT * Quadratic(form, along[1]));
  };
  const double first = triangle[0].value;
  const double rises[2] = { triangle[1].value - first, triangle[2].value - first };
  Interval linear(first);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const double value = first + seen->s[i] * rises[0] + seen->t[i] * rises[1];
    linear = i == 0 ? Interval(value) : Join(linear, Interval(value));
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    off[k] = halfOf(node.bend[k], way) * kUp;
  }
  double bent[3];
  std::ranges::copy(off, bent);
  std::optional<LocalCurves> local;
  const auto sharpen = [&]
  {
    local.emplace(node, triangle[0].xi);
    local->Reach(Farthest(ways));
    double own[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      own[k] = BentBetween(*seen, ways, local->bend[k], local->bends[k]);
    }
    Solve(node.solution, own);
    for (std::size_t k = 0; k < 3; ++k)
    {
      // The comparison is written so that a NaN keeps the known bound.
      bent[k] = own[k] < bent[k] ? own[k] : bent[k];
      off[k] = bent[k];
    }
  };
  const auto isCovered = [&]
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      off[k] = (off[k] + besides[k]) * kUp;
    }
    return std::ranges::all_of(node.wideEnds,
      [&](const EdgeNodeEnd& end)
      {
        const double less = end.Across(off) - (end.ofElement ? end.Across(beside) : 0.0);
        // The comparison is written so that a NaN is not covered.
        return std::ranges::all_of(std::span(places).first(corners.size()),
          [&](const Vec3& place) { return end.DepthOf(place) >= less; });
      });
  };
  if (!isCovered())
  {
    if (!node.slopes)
    {
      return std::nullopt;
    }
    sharpen();
    if (!isCovered())
    {
      return std::nullopt;
    }
  }

  double error = node.valueError;
  double most = 0.0;
  double change = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    way[k] = (way[k] + off[k]) * kUp;
    unsureOfWay[k] += off[k];
    error += node.slope[k] * shift[k];
    most += node.slope[k] * (besides[k] + 2.0 * beside[k]);
    change += node.slope[k] * std::max({ way[k], along[0][k], along[1][k] });
  }
  most += weight * error;
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
  const auto by = [&](double curved)
  {
    return (most + curved) * kUp +
      kRoundoffs * weight * (std::fabs(linear.lower) + std::fabs(linear.upper));
  };
  const auto widened = [&](double curved)
  {
    return Interval(
      rounding::Below(linear.lower - by(curved)), rounding::Above(linear.upper + by(curved)));
  };
  double notPolynomial = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    notPolynomial +=
      node.beside[k] * (way[k] + seen->mostS * along[0][k] + seen->mostT * along[1][k]);
  }
  double curved = halfOf(node.curve, way) + notPolynomial;
  PlanarValues found{ .values = widened(curved),
    .loose = Functions.HasJet() ? halfOf(node.rough, way) + notPolynomial : 0.0 };
  const auto isOpen = [&] { return wanted.Meets(found.values.lower, found.values.upper); };
  if (node.slopes && isOpen())
  {
    if (!local)
    {
      sharpen();
    }
    local->Reach(Farthest(ways));
    double own = BentBetween(*seen, ways, local->curve, local->curves) + notPolynomial;
    for (std::size_t k = 0; k < 3; ++k)
    {
      own += node.slope[k] * bent[k];
    }
    if (own < curved)
    {
      curved = own;
      found.values = widened(curved);
    }
  }
  if (isOpen())
  {
    FitPlane(triangle, *seen, part, found);
    found.error = (found.error + by(curved)) * kUp;
  }
  return found;
}
} // namespace pixelexact
