// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

namespace pixelexact
{
/// The points of a plane within a radius of a centre. A ray that lies in the plane does not meet
/// it. VTK has no implicit function for it, so only the tool and C++ offer it.
///
/// t and position are as accurate as a Plane's. If a ray's distance from the rim is below the error
/// of its position, the hit may be missing or superfluous.
class Disc final : public Surface
{
public:
  /// Throws Error if the normal is zero, the radius is not within 1e-100 to 1e100, or a number is
  /// not finite. The normal need not have unit length.
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
