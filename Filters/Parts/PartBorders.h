// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartBorders_h
#define PartBorders_h

#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkMultiProcessController;

namespace pixelexact
{
/// Returns the packed grid with copies of adjacent elements of other processes, marked as VTK's
/// ghost cells. These are elements with faces that have no neighbour in their own process, at most
/// their own size away from the box of the grid's elements. They are in the order of the processes,
/// so that ties at faces are resolved as in the whole mesh. All processes must call it; those
/// without cells get their input back. Throws Error on all processes.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> WithNeighbours(
  vtkUnstructuredGrid* grid, vtkMultiProcessController* processes);

/// Returns the grid with CellData kInnerFaces (HighOrderModel.h): the faces that have a neighbour
/// in the whole mesh, as FaceTable finds them. Elements with open faces are sent, without fields,
/// to the processes whose boxes they may touch. All processes must call it, also those without
/// cells. Throws Error on all processes.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> WithInnerFaces(
  vtkUnstructuredGrid* grid, vtkMultiProcessController* processes);
} // namespace pixelexact
#endif
