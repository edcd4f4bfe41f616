// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

#include <optional>

namespace pixelexact
{
/// Straight, from one point to another.
struct Segment
{
  Vec3 from{ 0.0 };
  Vec3 to{ 0.0 };
  double slack = 0.0; ///< how far off it may be, in each coordinate
};

/// The part of origin + t direction, tNear <= t <= tFar, that may lie in a box, widened by
/// rounding; nothing where none does, or where t or a coordinate is not finite.
std::optional<Segment> ClipRay(
  const Box3& box, const Vec3& origin, const Vec3& direction, double tNear, double tFar);
} // namespace pixelexact
