// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

namespace pixelexact
{
/// The part of a plane that is no further than a radius from a centre. A ray that lies in the plane
/// does not meet it. VTK has no implicit function for it: it is for the tool and C++ alone.
///
/// t and position are as accurate as a Plane's. A ray that passes the rim more closely than its
/// position may be off may be found on either side of it.
class Disc final : public Surface
{
public:
  /// Throws Error when the normal is zero, the radius is not within 1e-100 to 1e100, or a number is
  /// not finite. The normal need not be of unit length.
  Disc(const Vec3& centre, const Vec3& normal, double radius);

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;
  [[nodiscard]] bool IsFlat() const override { return true; }
  [[nodiscard]] std::vector<SurfacePatch> Implicit() const override;

private:
  Vec3 Centre;
  Vec3 UnitNormal;
  double Radius;
};
} // namespace pixelexact
