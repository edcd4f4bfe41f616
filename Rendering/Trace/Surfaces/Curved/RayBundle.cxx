// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Curved/RayBundle.h"

#include "Core/Math/Rounding.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Of a direction's other coordinates over the one along which all run.
constexpr double kSteepest = 4.0;
} // namespace

bool RayBundle::Begin(const RayLanes& rays, int first, int count, const Box3& about)
{
  Size = count;
  Offset = first;
  Vec3 mean(0.0);
  for (int i = first; i < first + count; ++i)
  {
    mean += Vec3(rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]);
  }
  const Vec3 size = glm::abs(mean);
  axes[2] = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  axes[0] = (axes[2] + 1) % 3;
  axes[1] = (axes[2] + 2) % 3;
  Sign = mean[axes[2]] < 0.0 ? -1.0 : 1.0;
  z0 = 0.5 * about.lower[axes[2]] + 0.5 * about.upper[axes[2]];
  Places = {};
  Slopes = {};
  Depths = {};
  Slack = 0.0;
  const auto along = static_cast<std::size_t>(axes[2]);
  for (int k = 0; k < count; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const int ray = first + k;
    Direction[i] = rays.direction[along][ray];
    Origin[i] = rays.origin[along][ray] - z0;
    for (std::size_t a = 0; a < 2; ++a)
    {
      const auto axis = static_cast<std::size_t>(axes[a]);
      slope[a][i] = rays.direction[axis][ray] / Direction[i];
      place[a][i] = std::fma(-slope[a][i], Origin[i], rays.origin[axis][ray]);
      if (!(Sign * Direction[i] > 0.0 && std::fabs(slope[a][i]) <= kSteepest) ||
        !std::isfinite(place[a][i]))
      {
        return false;
      }
      Slack = std::max(Slack,
        8.0 * kUnitRoundoff *
          (std::fabs(rays.origin[axis][ray]) +
            kSteepest * (std::fabs(rays.origin[along][ray]) + std::fabs(z0))));
      Places[a].least = std::min(Places[a].least, place[a][i]);
      Places[a].most = std::max(Places[a].most, place[a][i]);
      Slopes[a].least = std::min(Slopes[a].least, slope[a][i]);
      Slopes[a].most = std::max(Slopes[a].most, slope[a][i]);
    }
    Near[i] = DepthAt(k, rays.tNear[ray]) - Slack;
    Far[i] = DepthAt(k, rays.tFar[ray]) + Slack;
    if (rays.tNear[ray] <= rays.tFar[ray])
    {
      Depths.least = std::min(Depths.least, Near[i]);
      Depths.most = std::max(Depths.most, Far[i]);
    }
    else
    {
      Far[i] = -std::numeric_limits<double>::infinity();
    }
  }
  return true;
}

bool RayBundle::MayMeet(const Box3& box) const
{
  const double from = box.lower[axes[2]] - z0;
  const double to = box.upper[axes[2]] - z0;
  if (std::max(Sign * from, Sign * to) + Slack < Depths.least ||
    std::min(Sign * from, Sign * to) - Slack > Depths.most)
  {
    return false;
  }
  for (std::size_t a = 0; a < 2; ++a)
  {
    const double least = std::min(Slopes[a].least * from,
      std::min(Slopes[a].least * to, std::min(Slopes[a].most * from, Slopes[a].most * to)));
    const double most = std::max(Slopes[a].least * from,
      std::max(Slopes[a].least * to, std::max(Slopes[a].most * from, Slopes[a].most * to)));
    if (Places[a].least + least - Slack > box.upper[axes[a]] ||
      Places[a].most + most + Slack < box.lower[axes[a]])
    {
      return false;
    }
  }
  return true;
}

bool RayBundle::MayMeet(const Box3& box, int ray) const
{
  const auto i = static_cast<std::size_t>(ray);
  const double from = box.lower[axes[2]] - z0;
  const double to = box.upper[axes[2]] - z0;
  bool may = std::max(Sign * from, Sign * to) + Slack >= Near[i] &&
    std::min(Sign * from, Sign * to) - Slack <= Far[i];
  for (std::size_t a = 0; a < 2; ++a)
  {
    const double p = place[a][i] + slope[a][i] * from;
    const double q = place[a][i] + slope[a][i] * to;
    may = may && std::min(p, q) - Slack <= box.upper[axes[a]] &&
      std::max(p, q) + Slack >= box.lower[axes[a]];
  }
  return may;
}

double RayBundle::DepthOf(const Box3& box) const
{
  return std::min(Sign * (box.lower[axes[2]] - z0), Sign * (box.upper[axes[2]] - z0)) - Slack;
}

double RayBundle::DepthAt(int i, double t) const
{
  const auto at = static_cast<std::size_t>(i);
  return Sign * (Origin[at] + t * Direction[at]);
}

double RayBundle::TimeAt(int i, const Vec3& x) const
{
  const auto at = static_cast<std::size_t>(i);
  return ((x[axes[2]] - z0) - Origin[at]) / Direction[at];
}

void RayBundle::EndAt(int i, double depth)
{
  double& far = Far[static_cast<std::size_t>(i)];
  far = std::min(far, depth + Slack);
}

double RayBundle::Farthest() const
{
  return *std::max_element(Far.begin(), Far.begin() + Size);
}
} // namespace pixelexact
