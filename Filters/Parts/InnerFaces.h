// SPDX-License-Identifier: BSD-3-Clause
#ifndef InnerFaces_h
#define InnerFaces_h

#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkMultiProcessController;

namespace pixelexact
{
/// The grid with CellData kInnerFaces (HighOrderModel.h): which faces have something behind them in
/// the mesh whose parts the processes hold, as FaceTable decides it of the whole. Elements with
/// bare faces go, without their fields, to the processes whose boxes they may touch. All processes
/// must call it, those without cells too. Throws Error, and then on all of them.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> WithInnerFaces(
  vtkUnstructuredGrid* grid, vtkMultiProcessController* processes);
} // namespace pixelexact
#endif
