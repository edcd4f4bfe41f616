// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

#include <array>
#include <vector>

namespace pixelexact::testing
{
/// Surface::Meet for many rays at once, each with its tNear.
inline std::vector<std::vector<Hit>> MeetAll(
  const Surface& surface, const std::vector<Ray>& rays, const std::vector<double>& tNear)
{
  const auto padded = static_cast<std::size_t>(PaddedCount(static_cast<int>(rays.size())));
  std::array<std::vector<double>, 8> lanes;
  lanes.fill(std::vector<double>(padded, 1.0));
  lanes[7].assign(padded, kFarthest);
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    for (int d = 0; d < 3; ++d)
    {
      const auto axis = static_cast<std::size_t>(d);
      lanes[axis][i] = rays[i].origin[d];
      lanes[3 + axis][i] = rays[i].direction[d];
    }
    lanes[6][i] = tNear[i];
  }
  HitSlots slots;
  slots.Begin(static_cast<int>(rays.size()));
  surface.Meet({ { lanes[0].data(), lanes[1].data(), lanes[2].data() },
                 { lanes[3].data(), lanes[4].data(), lanes[5].data() }, lanes[6].data(),
                 lanes[7].data(), static_cast<int>(rays.size()) },
    slots);
  std::vector<std::vector<Hit>> all(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const int ray = static_cast<int>(i);
    for (int k = 0; k < slots.Count() && slots.T(k)[i] < kNoHit; ++k)
    {
      all[i].push_back({ slots.T(k)[i], slots.PointOf(k, ray).position, slots.StatusOf(k, ray) });
    }
  }
  return all;
}
/// The same from each ray's origin.
inline std::vector<std::vector<Hit>> MeetAll(const Surface& surface, const std::vector<Ray>& rays)
{
  return MeetAll(surface, rays, std::vector<double>(rays.size(), kNearest));
}
} // namespace pixelexact::testing
