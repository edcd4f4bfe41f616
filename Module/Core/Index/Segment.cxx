// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Index/Segment.h"

#include "Core/Math/Interval.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>

#include <algorithm>

namespace pixelexact
{
std::optional<Segment> ClipRay(
  const Box3& box, const Vec3& origin, const Vec3& direction, double tNear, double tFar)
{
  // Written so that a NaN is not finite.
  const Vec3 sum = origin * 0.0 + direction * 0.0;
  if (!(sum.x == 0.0 && sum.y == 0.0 && sum.z == 0.0))
  {
    return std::nullopt;
  }
  Interval t{ tNear, tFar };
  for (int d = 0; d < 3; ++d)
  {
    const Interval from = Interval(box.lower[d]) - Interval(origin[d]);
    const Interval to = Interval(box.upper[d]) - Interval(origin[d]);
    if (direction[d] == 0.0)
    {
      if (from.lower > 0.0 || to.upper < 0.0)
      {
        return std::nullopt;
      }
      continue;
    }
    t = Intersect(t, Join(from / Interval(direction[d]), to / Interval(direction[d])));
  }
  if (t.IsEmpty() || !t.IsFinite())
  {
    return std::nullopt;
  }
  // For a distant origin, the rounding of origin and product is that of the distance.
  const Vec3 far = glm::abs(origin) + t.Magnitude() * glm::abs(direction);
  const double slack = 4.0 * kUnitRoundoff * std::max({ far.x, far.y, far.z });
  return Segment{ origin + t.lower * direction, origin + t.upper * direction, slack };
}
} // namespace pixelexact
