// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
/// The exact area of a unit square's part within the signed distance `to` from its centre along the
/// unit vector `along`.
inline double ShareBehind(const glm::dvec2& along, double to)
{
  const double x = std::fabs(along.x);
  const double y = std::fabs(along.y);
  const double longer = std::max(x, y);
  const double shorter = std::min(x, y);
  const double corner = 0.5 * (longer + shorter);
  const double beside = corner - std::fabs(to);
  if (beside <= 0.0)
  {
    return to < 0.0 ? 0.0 : 1.0;
  }
  if (beside >= shorter)
  {
    return 0.5 + to / longer;
  }
  const double triangle = beside * beside / (2.0 * longer * shorter);
  return to < 0.0 ? triangle : 1.0 - triangle;
}
} // namespace pixelexact
