// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace pixelexact
{
struct Shot;

/// A contour in a picture's pixels.
struct ContourPath
{
  std::vector<CanvasPoint> points;
  std::size_t value = 0; ///< which of the values
};

/// The contours of a picture as paths, a tenth of a pixel exact: of one plane, the only surface,
/// where all contours were found and their course is proven; none otherwise. Their points are those
/// of TraceContours.
std::optional<std::vector<ContourPath>> PathsOfContours(
  const Shot& shot, const std::vector<double>& values);
} // namespace pixelexact
