// SPDX-License-Identifier: BSD-3-Clause
#ifndef CutTriangles_h
#define CutTriangles_h

#include "Core/Contour/CutFunction.h"
#include "Grids/FilterWork.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelexact
{
/// A triangulated cut-surface.
struct CutTriangles
{
  std::vector<Vec3> points;
  std::vector<std::array<std::int64_t, 3>> triangles;
  std::int64_t offSurface = 0; ///< points that could not be brought onto the surface
  bool aborted = false;
};

/// The part of a surface in a box, where the box is cut into cubes (of a plane: the part of the
/// plane into squares), `resolution` along its longest side, at least 1.
///
/// A plane: a grid over the rectangle about its polygon in the box. Any other: cubes are marched
/// through (MarchedCubes.h), and the vertices brought onto the surface, to rounding; those that
/// this takes further than two cubes' sides away stay where marching put them, and are counted.
///
/// Throws Error where it would not fit into memory, with `bytesPerPoint` of the caller's.
[[nodiscard]] CutTriangles TriangulateCut(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress);

/// Brings points onto a surface by Newton's iteration along the gradient, to rounding. Those that
/// this leads further away than their `reach` stay as they are; returns how many.
std::int64_t BringOntoSurface(
  const CutFunction& cut, std::span<const double> reach, std::span<Vec3> x);
} // namespace pixelexact
#endif
