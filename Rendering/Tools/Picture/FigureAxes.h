// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"

#include <string>

namespace pixelexact
{
class Canvas;
struct FigureLayout;
struct Shot;

// Lengths and coordinates along the sides of a picture. A picture has one scale if the view is
// parallel, or if it shows a single plane along the plane's normal.

/// Whether the picture has one scale. Reads only the direction of the view.
[[nodiscard]] bool HasOneScale(const Shot& shot);

/// Whether the picture has one scale, its sides run along axes of coordinates, and these have few
/// digits. Reads only the direction of the view.
[[nodiscard]] bool HasCoordinates(const Shot& shot);

/// The length of a pixel in world units where it is the same in the whole picture, else 0.
[[nodiscard]] double LengthOfPixel(const Shot& shot);

/// Limit of AspectOfBox, and its inverse.
inline constexpr double kMaxBoxAspect = 8.0;

/// The width over the height of the box around the mesh in a parallel picture with the direction of
/// the view, within the limits.
[[nodiscard]] double AspectOfBox(const Shot& shot);

/// Draws a frame around the picture of a shot that HasCoordinates, with ticks and names. `unit`: of
/// lengths, or nothing.
void DrawCoordinates(Canvas& canvas, const FigureLayout& layout, const Shot& shot,
  const std::string& unit, const Rgba& ink);
} // namespace pixelexact
