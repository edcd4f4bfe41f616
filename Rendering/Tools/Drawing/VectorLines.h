// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"

#include "Frames/ContourLabels.h"

#include <vector>

namespace pixelexact
{
/// A line over a picture's pixels.
struct VectorLine
{
  std::vector<CanvasPoint> points;
  double width;
  Rgba color;
};

/// The lines that a PDF or SVG draws over a picture's pixels: later lines on top, and labels above
/// all of them.
struct VectorLines
{
  std::vector<VectorLine> lines;
  std::vector<ContourLabel> labels;
  int labelSize = 0; ///< of their font, in pixels

  /// Draws the lines, clipped to the picture, whose lower left corner is that of the canvas.
  void Draw(Canvas& canvas, int width, int height) const;
};

/// The parts of a line that are not where a label is.
std::vector<std::vector<CanvasPoint>> PartsBeside(
  const std::vector<ContourLabel>& labels, const std::vector<CanvasPoint>& line);
} // namespace pixelexact
