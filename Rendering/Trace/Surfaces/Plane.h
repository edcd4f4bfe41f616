// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

namespace pixelexact
{
/// All x with (x - origin) . normal = 0. A ray that lies in the plane does not meet it.
class Plane final : public Surface
{
public:
  /// Throws Error if the normal is zero or a number is not finite. The normal need not have unit
  /// length.
  Plane(const Vec3& origin, const Vec3& normal);

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;
  [[nodiscard]] bool IsFlat() const override { return true; }
  [[nodiscard]] bool IsPlane() const override { return true; }
  [[nodiscard]] double Reach(const Chord& chord) const override;
  [[nodiscard]] bool IsClearOf(const Vec3& centre, double radius) const override;
  [[nodiscard]] std::vector<SurfacePatch> Implicit() const override;
  /// A point of the plane, the origin.
  [[nodiscard]] const Vec3& Point() const { return Origin; }

  /// Intersection of a ray's line with the plane: `t` may be negative, and is infinite or NaN if
  /// there is none.
  struct Crossing
  {
    double t;
    Vec3 position; ///< the same bits as Meet's
  };
  [[nodiscard]] Crossing Cross(const Ray& ray) const;

  /// The point that the plane was constructed from.
  [[nodiscard]] const Vec3& Through() const { return Origin; }

private:
  Vec3 Origin;
  Vec3 UnitNormal;
};
} // namespace pixelexact
