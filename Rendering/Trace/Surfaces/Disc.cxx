// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Disc.h"

#include "Trace/RayKernels.h"
#include "Trace/Surfaces/Arguments.h"

namespace pixelexact
{
Disc::Disc(const Vec3& centre, const Vec3& normal, double radius)
  : Centre(centre)
  , UnitNormal(0.0)
  , Radius(radius)
{
  CheckPosition(centre, "disc");
  UnitNormal = UnitDirection(ScaledDirection(normal, "disc", "normal"));
  CheckRadius(radius, "disc");
}

void Disc::Meet(const RayLanes& rays, HitSlots& hits) const
{
  const HitLanes slot = hits.Slot(0);
  GetRayKernels().meetPlane(Centre, UnitNormal, rays, slot);
  for (int i = 0; i < rays.count; ++i)
  {
    double squared = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      const double off = slot.position[d][i] - Centre[d];
      squared += off * off;
    }
    // The position may be NaN if the ray does not meet the plane.
    slot.t[i] = squared <= Radius * Radius ? slot.t[i] : kNoHit;
  }
}

Vec3 Disc::Normal(const SurfacePoint& /*point*/) const
{
  return UnitNormal;
}

std::vector<SurfacePatch> Disc::Implicit() const
{
  return { DiscPatch(Centre, UnitNormal, Radius) };
}
} // namespace pixelexact
