// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Torus.h"

#include "Trace/Surfaces/Arguments.h"
#include "Trace/Surfaces/PairArithmetic.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace pixelexact
{
Torus::Torus(const Vec3& centre, const Vec3& axis, double R, double r)
  : CircleRadius(R)
  , TubeRadius(r)
{
  CheckPosition(centre, "torus");
  CheckRadius(R, "torus");
  CheckRadius(r, "torus");
  if (!(r >= 1e-8 * R && R >= 1e-8 * r))
  {
    Refuse("torus", "one radius is more than 1e8 times the other; give a cylinder or a sphere.");
  }
  const Vec3 a = ScaledDirection(axis, "torus", "axis");
  Axis = UnitDirection(a);
  const int exponent = -(std::ilogb(R + r) + 1);
  const double circle = std::ldexp(R, exponent);
  const double tube = std::ldexp(r, exponent);
  const DoublePair circleSquare = ExactProduct(circle, circle);
  const DoublePair tubeSquare = ExactProduct(tube, tube);
  Form.centre = centre;
  Form.unit = std::ldexp(1.0, exponent);
  Form.sum = circleSquare + tubeSquare;
  Form.product = 4.0 * (circleSquare * tubeSquare);
  const DoublePair perLength = SquareRoot(4.0 * circleSquare /
    (ExactProduct(a.x, a.x) + ExactProduct(a.y, a.y) + ExactProduct(a.z, a.z)));
  for (int d = 0; d < 3; ++d)
  {
    Form.axis[d] = a[d] * perLength;
  }
  Form.slab = 2.0 * circle * tube * (1.0 + 1e-12);
  Form.reach = (circle + tube) * (1.0 + 1e-12);
}

void Torus::Meet(const RayLanes& rays, HitSlots& hits) const
{
  GetTorusKernels().meet(Form, rays, hits);
}

double Torus::Sagitta(
  const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const
{
  return ReachWithRoom(
    { a, atA.position, b, atB.position }, [this](const Chord& chord) { return Reach(chord); });
}

Vec3 Torus::Normal(const SurfacePoint& point) const
{
  // In the form's units no square overflows.
  const Vec3 x = (point.position - Form.centre) * Form.unit;
  const double R = CircleRadius * Form.unit;
  const double r = TubeRadius * Form.unit;
  const double height = glm::dot(x, Axis);
  const Vec3 across = x - height * Axis;
  const double distance = glm::length(across);
  if (!(distance > 0.0))
  {
    return Axis;
  }
  // The distance to the circle's nearest point or, on the inner part, to its farthest point is r.
  const auto off = [&](double along) { return std::fabs(std::hypot(along, height) - r); };
  const double along = off(distance - R) <= off(distance + R) ? distance - R : distance + R;
  const Vec3 normal = across * (along / distance) + height * Axis;
  return LargestOf(normal) > 0.0 ? UnitDirection(normal) : Axis;
}

std::vector<SurfacePatch> Torus::Implicit() const
{
  return { { ImplicitPolynomial::Torus(Form.centre, Axis, CircleRadius, TubeRadius) } };
}
} // namespace pixelexact
