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

/// The part of a surface in a box, where the box is cut into cubes (of a plane: the part of the
/// plane into squares), `resolution` along its longest side, at least 1.
///
/// A plane: a grid over the rectangle about its polygon in the box. Any other: cubes are marched
/// through (MarchCubes), and the vertices brought onto the surface, to rounding; those that
/// this takes further than two cubes' sides away stay where marching put them, and are counted.
///
/// Throws Error where it would not fit into memory, with `bytesPerPoint` of the caller's.
[[nodiscard]] CutTriangles TriangulateCut(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress);

/// Brings points onto a surface by Newton's iteration along the gradient, to rounding. Those that
/// this leads further away than their `reach` stay as they are; returns how many.
std::int64_t BringOntoSurface(
  const CutFunction& cut, std::span<const double> reach, std::span<Vec3> x);

/// The surface in a box, by marching through cubes, `resolution` along the box's longest side,
/// above 64 rounded up to at most 64 times a power of two. Larger cubes are halved where the
/// surface may be: of a quadric this leaves none out, of other functions it goes by the gradient at
/// a cube's centre, and by its corners. So time and memory grow with the surface, not with the box.
/// Parts of the surface between corners of the smallest cubes are missed. Vertices are brought onto
/// the surface; corners that triangles share are one point.
///
/// `bytesPerPoint`: with the triangles' own. Throws Error where it would not fit into memory.
[[nodiscard]] CutTriangles MarchCubes(const CutFunction& cut, const Box3& box, int resolution,
  double bytesPerPoint, const StepProgress& progress);

/// A triangulated cut-surface that ends where the mesh does.
struct ClippedCut
{
  /// Points of the whole surface that are left, by their numbers there. They come first.
  std::vector<std::int64_t> kept;
  std::vector<Vec3> rim; ///< points on the mesh's boundary; they come behind
  std::vector<std::array<std::int64_t, 3>> triangles; ///< of both
  std::int64_t atTheRim = 0;                          ///< triangles of the whole that were cut
};

/// Cuts off what of each triangle lies beyond the mesh, where some of its corners, not all, are
/// inside (`verdicts`): along each edge from an inner corner to another one the mesh's end is
/// searched for by halving, to 2^-16 of the edge, on the surface, and the last point that is proven
/// inside is taken. Ends of the mesh between corners of one kind are not seen. Parallel; the result
/// is independent of the number of threads.
[[nodiscard]] ClippedCut ClipToMesh(const CutFunction& cut, const CutTriangles& whole,
  std::span<const Verdict> verdicts, const Locator& locator);
} // namespace pixelexact
#endif
