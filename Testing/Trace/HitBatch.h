// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

#include <array>
#include <vector>

namespace pixelexact::testing
{
/// Rays as Surface::Meet takes them.
class RayBatch
{
public:
  RayBatch(const std::vector<Ray>& rays, const std::vector<double>& tNear)
    : Count(static_cast<int>(rays.size()))
  {
    const auto padded = static_cast<std::size_t>(PaddedCount(Count));
    Lanes.fill(std::vector<double>(padded, 1.0));
    Lanes[7].assign(padded, kFarthest);
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      for (int d = 0; d < 3; ++d)
      {
        const auto axis = static_cast<std::size_t>(d);
        Lanes[axis][i] = rays[i].origin[d];
        Lanes[3 + axis][i] = rays[i].direction[d];
      }
      Lanes[6][i] = tNear[i];
    }
  }

  [[nodiscard]] RayLanes View(bool nearestOnly = false) const
  {
    return { { Lanes[0].data(), Lanes[1].data(), Lanes[2].data() },
      { Lanes[3].data(), Lanes[4].data(), Lanes[5].data() }, Lanes[6].data(), Lanes[7].data(),
      Count, nearestOnly };
  }

private:
  int Count;
  std::array<std::vector<double>, 8> Lanes;
};

/// A hit and where it is on the surface.
struct PointHit : Hit
{
  SurfacePoint point;
};

/// Surface::Meet for many rays at once, each with its tNear.
inline std::vector<std::vector<PointHit>> MeetPoints(const Surface& surface,
  const std::vector<Ray>& rays, const std::vector<double>& tNear, bool nearestOnly = false,
  std::int64_t work = kRayWork)
{
  const RayBatch batch(rays, tNear);
  HitSlots slots;
  slots.Begin(static_cast<int>(rays.size()));
  RayLanes lanes = batch.View(nearestOnly);
  lanes.work = work;
  surface.Meet(lanes, slots);
  std::vector<std::vector<PointHit>> all(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const int ray = static_cast<int>(i);
    for (int k = 0; k < slots.Count() && slots.T(k)[i] < kNoHit; ++k)
    {
      const SurfacePoint point = slots.PointOf(k, ray);
      all[i].push_back({ { slots.T(k)[i], point.position, slots.StatusOf(k, ray) }, point });
    }
  }
  return all;
}
/// The same from each ray's origin.
inline std::vector<std::vector<PointHit>> MeetPoints(
  const Surface& surface, const std::vector<Ray>& rays, bool nearestOnly = false)
{
  return MeetPoints(surface, rays, std::vector<double>(rays.size(), kNearest), nearestOnly);
}

/// Hits without their points.
inline std::vector<std::vector<Hit>> MeetAll(
  const Surface& surface, const std::vector<Ray>& rays, const std::vector<double>& tNear)
{
  std::vector<std::vector<Hit>> all;
  for (const auto& hits : MeetPoints(surface, rays, tNear))
  {
    all.emplace_back(hits.begin(), hits.end());
  }
  return all;
}
inline std::vector<std::vector<Hit>> MeetAll(const Surface& surface, const std::vector<Ray>& rays)
{
  return MeetAll(surface, rays, std::vector<double>(rays.size(), kNearest));
}
} // namespace pixelexact::testing
