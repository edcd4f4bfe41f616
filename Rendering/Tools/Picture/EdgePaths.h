// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"

#include <optional>
#include <vector>

namespace pixelexact
{
struct Frame;
struct Shot;

/// The lines along which a plane, the only surface, crosses from one element into another, or out
/// of the mesh, in pixels; none where it is another surface, and where lines would be in an eighth
/// of the pixels, which small elements would make one dark patch.
///
/// Of pixels beside each other that show different elements, points between their centres are
/// located until the place is known to 1/64 of a pixel; a line through these places is 1/32 exact,
/// but for places where three elements meet, which are to a pixel. An element that no pixel's
/// centre shows has no lines, and pixels that are unknown have none.
std::optional<std::vector<std::vector<CanvasPoint>>> PathsOfEdges(
  const Shot& shot, const Frame& frame);
} // namespace pixelexact
