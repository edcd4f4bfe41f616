// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"
#include "Drawing/PixelPaths.h"

#include "Core/Math/Vec.h"
#include "Trace/Scene.h"

#include <array>
#include <vector>

// Positions of the lines of a mesh outline.
namespace pixelexact
{
struct Frame;
struct Shot;

/// A scene with the boundary of the mesh only or, where `undeformed`, of the mesh before --warp.
/// Throws Error where there is none, and UsageError where nothing is deformed.
Scene BoundaryOf(const Shot& shot, bool undeformed);

/// The parts of the box's edges that are not hidden by a cut-surface of the frame, to a quarter of
/// a pixel, as points with four to a pixel.
std::vector<std::vector<CanvasPoint>> SeenEdgesOfBox(const Shot& shot, const Frame& frame);

/// Lines of the boundary, traced on a finer grid of pixels than the picture's.
struct BoundaryLines
{
  std::vector<PixelStep> steps;
  double fine; ///< number of fine pixels to one of the picture
};
BoundaryLines LinesOfBoundary(const Shot& shot, bool undeformed, int width, int height);
} // namespace pixelexact
