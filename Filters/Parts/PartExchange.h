// SPDX-License-Identifier: BSD-3-Clause
#ifndef PartExchange_h
#define PartExchange_h

#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

class vtkMultiProcessController;

// Elements from process to process. What is called here all processes must call.
namespace pixelexact
{
/// Throws Error on all processes where `problem` is not empty on any: the first one's.
PIXELEXACTFILTERS_EXPORT void AgreeThatAllIsWell(
  const std::string& problem, vtkMultiProcessController* processes);

/// Some cells of a grid with coefficients, packed; empty where there are none. `fields`: with
/// these.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> PackedCells(
  vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells, bool fields);

/// The packed grids of all processes, in their order; those without cells are empty.
PIXELEXACTFILTERS_EXPORT std::vector<vtkSmartPointer<vtkUnstructuredGrid>> FromAll(
  vtkUnstructuredGrid* packed, vtkMultiProcessController* processes);

/// The same, of the first process alone; none on others.
PIXELEXACTFILTERS_EXPORT std::vector<vtkSmartPointer<vtkUnstructuredGrid>> FromAllToFirst(
  vtkUnstructuredGrid* packed, vtkMultiProcessController* processes);

/// Packed grids one after the other, without the empty ones; null where all are.
PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> Appended(
  const std::vector<vtkSmartPointer<vtkUnstructuredGrid>>& packed);
} // namespace pixelexact
#endif
