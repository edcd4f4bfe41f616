// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/AffineMap.h"
#include "Trace/Surfaces/Surface.h"
#include "Trace/Surfaces/SurfaceKernels.h"

#include <array>
#include <span>

namespace pixelexact
{
/// All x with (x-c)^T Q (x-c) + 2 b.(x-c) + k = 0: spheres, cylinders, cones, paraboloids, pairs of
/// planes and so on. A ray that touches the surface meets it once; a ray that lies in it does not
/// meet it.
///
/// Roots are found in pairs of doubles, about the ray's point closest to c. t and positions have
/// errors of about a unit in the last place for the given numbers, from any distance, unless the
/// ray is nearly tangent or a cone is as slender as a millionth of a degree. Lengths are between
/// 1e-100 and 1e100.
class Quadric final : public Surface
{
public:
  /// f(x) = form(linear x + offset). Throws Error if f is constant, a number is not finite, or the
  /// map has no inverse; `what` names the surface in the message.
  explicit Quadric(
    const QuadraticForm& form, const AffineMap& toFunction = {}, const char* what = "quadric");

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  /// Along the gradient; where that is zero, as at a cone's apex, an arbitrary direction.
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] double SagittaOver(
    const std::array<Ray, 3>& rays, const std::array<Vec3, 3>& hits) const override;
  [[nodiscard]] bool HasSagitta() const override { return true; }
  [[nodiscard]] double Reach(const Chord& chord) const override;
  [[nodiscard]] bool IsClearOf(const Vec3& centre, double radius) const override;
  [[nodiscard]] std::vector<SurfacePatch> Implicit() const override;

  /// The equation's form, scaled by a power of two.
  [[nodiscard]] const QuadraticForm& GetForm() const { return Form; }

private:
  [[nodiscard]] double SagittaAmong(std::span<const Ray> rays, std::span<const Vec3> hits) const;
  /// Q (x - c) + b, half of the form's gradient.
  [[nodiscard]] Vec3 HalfGradient(const Vec3& position) const;

  friend Quadric MakeCylinder(const Vec3&, const Vec3&, double, const AffineMap&);
  friend Quadric MakeCone(const Vec3&, const Vec3&, double, const AffineMap&);

  QuadraticForm Form;
  AxisForm Round;
  bool IsSphere = false;
  bool IsRound = false;
  bool IsCentred = false;
  DoublePair SquaredRadius;
};

// `toFunction` transforms the surface: it maps the world to the space in which the surface is as
// described. The functions throw Error if a number is not finite or out of range, or the map has no
// inverse.

/// The radius is between 1e-100 and 1e100.
Quadric MakeSphere(const Vec3& centre, double radius, const AffineMap& toFunction = {});
/// Infinite in both directions. The axis need not have unit length.
Quadric MakeCylinder(
  const Vec3& point, const Vec3& axis, double radius, const AffineMap& toFunction = {});
/// Infinite double cone. The angle between axis and surface is between 0 and 90 degrees; the axis
/// need not have unit length.
Quadric MakeCone(
  const Vec3& apex, const Vec3& axis, double halfAngleDegrees, const AffineMap& toFunction = {});
/// a0 x^2 + a1 y^2 + a2 z^2 + a3 xy + a4 yz + a5 xz + a6 x + a7 y + a8 z + a9 = 0, as vtkQuadric.
/// Without second-order terms it is a plane.
Quadric MakeQuadric(const std::array<double, 10>& a, const AffineMap& toFunction = {});
} // namespace pixelexact
