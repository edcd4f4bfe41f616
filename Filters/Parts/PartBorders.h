// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartBorders_h
#define PartBorders_h

#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkMultiProcessController;

namespace pixelexact
{
/// The grid, packed, with copies of elements that other processes hold beside it, marked as VTK
/// marks ghost cells: those with faces behind which their own process has nothing, and which are no
/// farther from the box of the grid's elements than they are large. In the order of the processes,
/// so that ties at faces are decided as in the whole mesh. All processes must call it, those
/// without cells too, which get what they gave. Throws Error, and then on all of them.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> WithNeighbours(
  vtkUnstructuredGrid* grid, vtkMultiProcessController* processes);

/// The grid with CellData kInnerFaces (HighOrderModel.h): which faces have something behind them in
/// the mesh whose parts the processes hold, as FaceTable decides it of the whole. Elements with
/// bare faces go, without their fields, to the processes whose boxes they may touch. All processes
/// must call it, those without cells too. Throws Error, and then on all of them.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> WithInnerFaces(
  vtkUnstructuredGrid* grid, vtkMultiProcessController* processes);
} // namespace pixelexact
#endif
