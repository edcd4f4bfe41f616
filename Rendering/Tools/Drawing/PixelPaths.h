// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"

#include <vector>

namespace pixelexact
{
/// A side between two pixels of a grid at which a property changes.
struct PixelStep
{
  int i = 0; ///< the left pixel, or the lower one
  int j = 0;
  bool across = true;  ///< the other one is to the right; else above
  CanvasPoint at = {}; ///< where it changes, between the pixels' centres

  /// A step in the middle between the centres.
  static PixelStep Right(int i, int j) { return { i, j, true, { i + 1.0, j + 0.5 } }; }
  static PixelStep Up(int i, int j) { return { i, j, false, { i + 0.5, j + 1.0 } }; }
};

/// Joins steps to lines through their positions. Lines run between ends, or between junctions of
/// three or more, which are at the mean of their positions, at most a pixel off. Points within
/// `tolerance` of the line without them are left out. Closed lines end where they begin.
std::vector<std::vector<CanvasPoint>> PathsOf(
  const std::vector<PixelStep>& steps, double tolerance);
} // namespace pixelexact
