// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

namespace pixelexact
{
using Vec3 = glm::dvec3;

/// An axis-aligned box; empty when lower > upper.
struct Box3
{
  Vec3 lower{ 0.0 };
  Vec3 upper{ 0.0 };

  [[nodiscard]] bool Contains(const Vec3& x) const
  {
    // Written so that a NaN coordinate is not contained.
    return x.x >= lower.x && x.x <= upper.x && x.y >= lower.y && x.y <= upper.y && x.z >= lower.z &&
      x.z <= upper.z;
  }
};
} // namespace pixelexact
