// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"

#include <optional>
#include <vector>

namespace pixelexact
{
struct Frame;
struct Shot;

/// Finds the lines, in pixels, along which a plane crosses from one element into another, or out of
/// the mesh. The plane must be the only surface. None for other surfaces, and where lines would
/// cover an eighth of the pixels, as for small elements.
///
/// For neighbouring pixels with different elements, points between their centres are located until
/// the crossing is known to 1/64 of a pixel. A line through the crossings is exact to 1/32 of a
/// pixel, and to a pixel where three elements meet. Elements that contain no pixel's centre have no
/// lines, and neither have unknown pixels.
std::optional<std::vector<std::vector<CanvasPoint>>> PathsOfEdges(
  const Shot& shot, const Frame& frame);
} // namespace pixelexact
