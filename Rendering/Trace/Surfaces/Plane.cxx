// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Plane.h"

#include "Core/Base/Error.h"
#include "Core/Math/Rounding.h"
#include "Trace/RayKernels.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
Plane::Plane(const Vec3& origin, const Vec3& normal)
  : Origin(origin)
{
  // Scaled first, so that the length neither overflows nor underflows.
  const double largest =
    std::max({ std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z) });
  if (!std::isfinite(origin.x + origin.y + origin.z) ||
    !std::isfinite(normal.x + normal.y + normal.z))
  {
    throw Error("plane: an origin or normal coordinate is not a finite number.");
  }
  if (!(largest > 0.0))
  {
    throw Error("plane: the normal is zero, so there is no plane; give a direction.");
  }
  UnitNormal = glm::normalize(normal / largest);
}

void Plane::Meet(const RayLanes& rays, HitSlots& hits) const
{
  GetRayKernels().meetPlane(Origin, UnitNormal, rays, hits.Slot(0));
}

Plane::Crossing Plane::Cross(const Ray& ray) const
{
  const double t = glm::dot(UnitNormal, Origin - ray.origin) / glm::dot(UnitNormal, ray.direction);
  const Vec3 x = ray.origin + t * ray.direction;
  // As in the kernel: the rounding of t moves x off the plane, and the correction moves it back.
  return { t, x - UnitNormal * glm::dot(UnitNormal, x - Origin) };
}

double Plane::Reach(const Chord& chord) const
{
  return ReachOfPlane(chord, Origin, UnitNormal);
}

bool Plane::IsClearOf(const Vec3& centre, double radius) const
{
  const double rounding =
    16.0 * kUnitRoundoff * (glm::length(centre) + glm::length(Origin) + radius);
  return std::fabs(glm::dot(UnitNormal, centre - Origin)) > radius + rounding;
}

Vec3 Plane::Normal(const SurfacePoint& /*point*/) const
{
  return UnitNormal;
}

std::vector<SurfacePatch> Plane::Implicit() const
{
  return { { ImplicitPolynomial::Plane(Origin, UnitNormal) } };
}
} // namespace pixelexact
