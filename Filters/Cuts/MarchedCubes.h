// SPDX-License-Identifier: BSD-3-Clause
#ifndef MarchedCubes_h
#define MarchedCubes_h

#include "Cuts/CutTriangles.h"

namespace pixelexact
{
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
} // namespace pixelexact
#endif
