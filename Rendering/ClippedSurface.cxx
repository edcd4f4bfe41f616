// SPDX-License-Identifier: BSD-3-Clause
#include "ClippedSurface.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
ClippedSurface::ClippedSurface(
  std::shared_ptr<const Surface> whole, std::vector<KeptHalfSpace> kept)
  : Whole(std::move(whole))
  , Kept(std::move(kept))
{
}

bool ClippedSurface::Keeps(const Vec3& position) const
{
  return std::all_of(Kept.begin(), Kept.end(),
    [&position](const KeptHalfSpace& half) {
      return half[0] * position.x + half[1] * position.y + half[2] * position.z + half[3] >= 0.0;
    });
}

void ClippedSurface::NextHit(const RayLanes& rays, const double* tMin, const HitLanes& hits) const
{
  Whole->NextHit(rays, tMin, hits);
  // Hits that are cut away are stepped over one by one. Each starts beyond the last, so the loop
  // ends with the surface's hits.
  for (int i = 0; i < rays.count; ++i)
  {
    const auto& [t, x] = hits;
    Hit hit{ t[i], { x[0][i], x[1][i], x[2][i] } };
    if (!(hit.t < kNoHit) || Keeps(hit.position))
    {
      continue;
    }
    const Ray ray{ { rays.origin[0][i], rays.origin[1][i], rays.origin[2][i] },
      { rays.direction[0][i], rays.direction[1][i], rays.direction[2][i] } };
    while (hit.t < kNoHit && !Keeps(hit.position))
    {
      hit = NextHitOf(*Whole, ray, hit.t);
    }
    t[i] = hit.t;
    for (int d = 0; d < 3; ++d)
    {
      x[d][i] = hit.position[d];
    }
  }
}

Vec3 ClippedSurface::Normal(const Vec3& position) const
{
  return Whole->Normal(position);
}
} // namespace pixelexact
