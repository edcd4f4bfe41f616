// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridCheck_h
#define GridCheck_h

#include "PixelExactFiltersModule.h"

class vtkUnstructuredGrid;

namespace pixelexact
{
/// Throws InvalidData where a grid that came from a file contradicts itself: cells that point
/// beyond the points, or arrays of other lengths than their data set's, would be read out of bounds
/// later.
PIXELEXACTFILTERS_EXPORT void CheckConsistency(vtkUnstructuredGrid& grid);
} // namespace pixelexact
#endif
