// SPDX-License-Identifier: BSD-3-Clause
#ifndef SlabArray_h
#define SlabArray_h

#include "PixelExactFiltersModule.h"

#include "Formats/Slab.h"

#include <optional>

class vtkUnstructuredGrid;

// Where the slab of a plane mesh lies: FieldData PixelExact.Mesh.Slab, double x 2, middle and
// thickness along z. Absent: the mesh is no plane one.
namespace pixelexact
{
/// To be called after StoreMesh, which drops what was there.
void StoreSlab(const Slab& slab, vtkUnstructuredGrid* grid);

/// None also where the array holds what no slab has.
PIXELEXACTFILTERS_EXPORT std::optional<Slab> SlabOf(vtkUnstructuredGrid* grid);
} // namespace pixelexact
#endif
