// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColorDefaults_h
#define ColorDefaults_h

#include "PixelExactFiltersModule.h"

class vtkUnstructuredGrid;

namespace pixelexact
{
/// Prepares the arrays of a grid's fields for a program that colours by arrays, as ParaView does.
/// The first field becomes the active scalars. The range that VTK reports of each field's array, of
/// its components and its magnitude, becomes the proven range of the field over the grid, which
/// contains the values at the points; each end is off an attained value by at most a thousandth of
/// the range. An array that is changed afterwards (vtkDataArray::Modified) reports the range of its
/// own values, as does one of a field that has no finite bound. Grids whose coefficients do not fit
/// keep their arrays as they are.
PIXELEXACTFILTERS_EXPORT void StoreColorDefaults(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
