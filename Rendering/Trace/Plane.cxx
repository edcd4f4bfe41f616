// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Plane.h"

#include "Core/Base/Error.h"

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

void Plane::NextHit(std::span<const Ray> rays, std::span<const double> tMin, std::span<double> t,
  std::span<Vec3> position) const
{
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const Ray& ray = rays[i];
    const double slope = glm::dot(UnitNormal, ray.direction);
    const double at = glm::dot(UnitNormal, Origin - ray.origin) / slope;
    // A slope of zero makes `at` infinite or NaN: no hit either way.
    if (!(at > tMin[i]) || !std::isfinite(at))
    {
      t[i] = kNoHit;
      continue;
    }
    t[i] = at;
    const Vec3 x = ray.origin + at * ray.direction;
    // From a far origin the rounding of t moves x off the plane; put it back along the normal.
    position[i] = x - UnitNormal * glm::dot(UnitNormal, x - Origin);
  }
}

Vec3 Plane::Normal(const Vec3& /*position*/) const
{
  return UnitNormal;
}
} // namespace pixelexact
