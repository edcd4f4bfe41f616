// SPDX-License-Identifier: BSD-3-Clause
#ifndef CutTriangles_h
#define CutTriangles_h

#include "Core/Base/Verdict.h"
#include "Core/Contour/CutFunction.h"
#include "Core/Location/Locator.h"
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

/// Triangulates the part of a surface in a box. `resolution`, at least 1, is the number of cubes
/// along the box's longest side. A plane becomes a grid over the rectangle about its polygon in the
/// box. Other surfaces are triangulated by marching cubes (MarchCubes), and their vertices are
/// moved onto the surface, to rounding. Vertices that would move further than two cubes' sides stay
/// in place and are counted. Throws Error where the result would not fit into memory, with
/// `bytesPerPoint` for the caller's data.
[[nodiscard]] CutTriangles TriangulateCut(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress);

/// Moves points onto a surface by Newton's iteration along the gradient, to rounding. Points that
/// would move further than their `reach` stay; returns their number.
std::int64_t BringOntoSurface(
  const CutFunction& cut, std::span<const double> reach, std::span<Vec3> x);

/// Triangulates the surface in a box by marching cubes, `resolution` along the box's longest side,
/// rounded up above 64 to at most 64 times a power of two. Larger cubes are subdivided where the
/// surface may be. For a quadric this loses nothing. For other functions it depends on the gradient
/// at a cube's centre and on the values at its corners. Time and memory grow with the surface, not
/// with the box. Parts of the surface between corners of the smallest cubes are missed. Vertices
/// are moved onto the surface; corners that triangles share are one point. `bytesPerPoint` includes
/// the triangles. Throws Error where the result would not fit into memory.
[[nodiscard]] CutTriangles MarchCubes(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress);

/// A triangulated cut-surface that ends where the mesh does.
struct ClippedCut
{
  /// Numbers, in the whole surface, of the points that are kept. They are the first points.
  std::vector<std::int64_t> kept;
  std::vector<Vec3> rim; ///< points on the mesh's boundary; they follow the kept points
  std::vector<std::array<std::int64_t, 3>> triangles; ///< of kept and rim points
  std::int64_t atTheRim = 0; ///< triangles of the whole surface that were cut
};

/// Clips triangles that have corners inside and outside the mesh (`verdicts`). Along each edge from
/// an inner corner to another one, bisection on the surface finds the mesh's boundary to 2^-16 of
/// the edge and takes the last point that is proven inside. Boundaries between corners of the same
/// verdict are missed. Parallel; the result does not depend on the number of threads.
[[nodiscard]] ClippedCut ClipToMesh(const CutFunction& cut, const CutTriangles& whole,
  std::span<const Verdict> verdicts, const Locator& locator);
} // namespace pixelexact
#endif
