// SPDX-License-Identifier: BSD-3-Clause
#include "ClippedSurface.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
ClippedSurface::ClippedSurface(std::shared_ptr<const Surface> whole, std::vector<HalfSpace> kept)
  : Whole(std::move(whole))
  , Kept(std::move(kept))
{
}

bool ClippedSurface::Keeps(const Vec3& position) const
{
  return std::all_of(Kept.begin(), Kept.end(),
    [&position](const HalfSpace& half) {
      return half[0] * position.x + half[1] * position.y + half[2] * position.z + half[3] >= 0.0;
    });
}

void ClippedSurface::NextHit(std::span<const Ray> rays, std::span<const double> tMin,
  std::span<double> t, std::span<Vec3> position) const
{
  Whole->NextHit(rays, tMin, t, position);
  // Hits that are cut away are stepped over one by one. Each starts beyond the last, so the loop
  // ends with the surface's hits.
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    while (t[i] < kNoHit && !Keeps(position[i]))
    {
      const double last = t[i];
      Whole->NextHit(
        rays.subspan(i, 1), std::span(&last, 1), t.subspan(i, 1), position.subspan(i, 1));
    }
  }
}

Vec3 ClippedSurface::Normal(const Vec3& position) const
{
  return Whole->Normal(position);
}
} // namespace pixelexact
