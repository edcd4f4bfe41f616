// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/RayBundle.h"

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/PairArithmetic.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Along which a direction is longest.
std::size_t LongestOf(const Vec3& direction)
{
  const Vec3 size = glm::abs(direction);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// o - d / d_k o_k, where the two are far larger than it: the ray's own point, not one beside it.
double PlaceOf(double origin, double direction, double along, const DoublePair& depth)
{
  const DoublePair slope = DoublePair{ direction, 0.0 } / DoublePair{ along, 0.0 };
  return (DoublePair{ origin, 0.0 } - slope * depth).high;
}
} // namespace

bool RayBundle::Begin(const RayLanes& rays, int first, int count, const Box3& about)
{
  Size = count;
  Offset = first;
  const auto directionOf = [&rays](int ray)
  { return Vec3(rays.direction[0][ray], rays.direction[1][ray], rays.direction[2][ray]); };
  const std::size_t along = LongestOf(directionOf(first));
  const double* const directions = rays.direction[along];
  axes = { static_cast<int>((along + 1) % 3), static_cast<int>((along + 2) % 3),
    static_cast<int>(along) };
  sign = directions[first] < 0.0 ? -1.0 : 1.0;
  z0 = 0.5 * about.lower[axes[2]] + 0.5 * about.upper[axes[2]];
  const Vec3 largest = glm::max(glm::abs(about.lower), glm::abs(about.upper));
  const double around = std::max({ largest.x, largest.y, largest.z });
  Places = {};
  Slopes = {};
  Depths = {};
  Slack = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    const int ray = first + static_cast<int>(i);
    // A NaN is not positive.
    if (LongestOf(directionOf(ray)) != along || !(sign * directions[ray] > 0.0))
    {
      return false;
    }
    Direction[i] = directions[ray];
    const DoublePair depth = ExactSum(rays.origin[along][ray], -z0);
    Origin[i] = depth.high;
    double size = around + std::fabs(rays.origin[along][ray]);
    for (std::size_t a = 0; a < 2; ++a)
    {
      const auto axis = static_cast<std::size_t>(axes[a]);
      slope[a][i] = rays.direction[axis][ray] / Direction[i];
      place[a][i] = PlaceOf(rays.origin[axis][ray], rays.direction[axis][ray], Direction[i], depth);
      size += std::fabs(rays.origin[axis][ray]);
      Places[a].Add(place[a][i]);
      Slopes[a].Add(slope[a][i]);
    }
    slack[i] = 16.0 * kUnitRoundoff * size;
    Slack = std::max(Slack, slack[i]);
    const bool isThere = rays.tNear[ray] <= rays.tFar[ray] && std::isfinite(size);
    near[i] = DepthAt(static_cast<int>(i), rays.tNear[ray]) - slack[i];
    far[i] = isThere ? DepthAt(static_cast<int>(i), rays.tFar[ray]) + slack[i]
                     : -std::numeric_limits<double>::infinity();
    if (isThere)
    {
      Depths.Add(near[i]);
      Depths.Add(far[i]);
    }
  }
  return true;
}

// The same sums as for a ray alone, of numbers that are no larger, or no smaller: rounding is
// monotone, so that no box is left out that one of the rays would not leave out.
bool RayBundle::MayMeet(const Box3& box) const
{
  const double from = box.lower[axes[2]] - z0;
  const double to = box.upper[axes[2]] - z0;
  bool may = std::max(sign * from, sign * to) + Slack >= Depths.least &&
    std::min(sign * from, sign * to) - Slack <= Depths.most;
  for (std::size_t a = 0; a < 2; ++a)
  {
    const auto [least, most] = std::minmax(
      { Slopes[a].least * from, Slopes[a].least * to, Slopes[a].most * from, Slopes[a].most * to });
    may = may && Places[a].least + least - Slack <= box.upper[axes[a]] &&
      Places[a].most + most + Slack >= box.lower[axes[a]];
  }
  return may;
}

double RayBundle::DepthOf(const Box3& box) const
{
  return std::min(sign * (box.lower[axes[2]] - z0), sign * (box.upper[axes[2]] - z0)) - Slack;
}

double RayBundle::DepthAt(int i, double t) const
{
  const auto at = static_cast<std::size_t>(i);
  return sign * (Origin[at] + t * Direction[at]);
}

double RayBundle::TimeAt(int i, const Vec3& x) const
{
  const auto at = static_cast<std::size_t>(i);
  return ((x[axes[2]] - z0) - Origin[at]) / Direction[at];
}

void RayBundle::EndAt(int i, double depth)
{
  const auto at = static_cast<std::size_t>(i);
  far[at] = std::min(far[at], depth + slack[at]);
}

double RayBundle::Farthest() const
{
  return *std::max_element(far.begin(), far.begin() + Size);
}
} // namespace pixelexact
