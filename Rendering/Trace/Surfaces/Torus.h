// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"
#include "Trace/Surfaces/SurfaceKernels.h"

namespace pixelexact
{
/// All points at distance r from a circle of radius R about an axis. If r > R, the tube intersects
/// itself, and both the outer part and the inner one, a lemon about the axis, belong to the
/// surface.
///
/// t and positions have errors of about a unit in the last place for the given numbers, unless the
/// ray is nearly tangent. If pairs of doubles do not decide whether the ray touches the surface, it
/// meets the surface once, with HitStatus::Undecided.
class Torus final : public Surface
{
public:
  /// The axis need not have unit length. Throws Error if it is zero, a radius is not positive, a
  /// number is not finite, or r / R is not between 1e-8 and 1e8.
  Torus(const Vec3& centre, const Vec3& axis, double R, double r);

  [[nodiscard]] const Vec3& Centre() const { return Form.centre; }
  [[nodiscard]] const Vec3& AxisDirection() const { return Axis; }
  /// Radius of the circle, and of the tube around it.
  [[nodiscard]] double Radius() const { return CircleRadius; }
  [[nodiscard]] double Tube() const { return TubeRadius; }

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] bool HasSagitta() const override { return true; }
  [[nodiscard]] double Reach(const Chord& chord) const override;
  [[nodiscard]] bool IsClearOf(const Vec3& centre, double radius) const override;
  [[nodiscard]] std::vector<SurfacePatch> Implicit() const override;

private:
  TorusForm Form;
  Vec3 Axis; ///< of unit length
  double CircleRadius;
  double TubeRadius;
};
} // namespace pixelexact
