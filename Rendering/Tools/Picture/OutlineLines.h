// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"
#include "Drawing/PixelPaths.h"

#include "Core/Math/Vec.h"
#include "Trace/Scene.h"

#include <array>
#include <vector>

// Where the lines of a mesh outline are.
namespace pixelexact
{
struct Frame;
struct Shot;

/// Of the box that holds the mesh.
std::array<Vec3, 8> CornersOfBox(const Shot& shot);

/// A scene of the mesh's boundary alone. Throws Error where it has none.
Scene BoundaryOf(const Shot& shot);

/// The parts of the box's edges that no cut-surface of the frame hides, to a quarter of a pixel:
/// points four to a pixel.
std::vector<std::vector<CanvasPoint>> SeenEdgesOfBox(const Shot& shot, const Frame& frame);

/// Where the boundary, traced for itself, has lines: of a grid of pixels finer than the picture's.
struct BoundaryLines
{
  std::vector<PixelStep> steps;
  double fine; ///< so many of its pixels to one of the picture
};
BoundaryLines LinesOfBoundary(const Shot& shot, int width, int height);
} // namespace pixelexact
