// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointBounds_h
#define PointBounds_h

#include <array>

class vtkDataObject;

namespace pixelexact
{
/// The box (xmin, xmax, ymin, ymax, zmin, zmax) of the points of a grid, or of all blocks of
/// composite data.
[[nodiscard]] std::array<double, 6> BoundsOf(vtkDataObject* data);
} // namespace pixelexact
#endif
