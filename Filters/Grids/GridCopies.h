// SPDX-License-Identifier: BSD-3-Clause
#ifndef GridCopies_h
#define GridCopies_h

#include "Core/Element/Truncation.h"
#include "PixelExactFiltersModule.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <span>

namespace pixelexact
{
/// Cells of a grid, in the order given, with the points that they have and all data of both; field
/// data are shared. As vtkExtractCells, whose module of VTK 9.1 loads MPI.
vtkSmartPointer<vtkUnstructuredGrid> ExtractedCells(
  vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells);

/// Grids one after the other, without merging points, in the best precision that their points have.
/// Arrays that not all have alike are left out.
vtkSmartPointer<vtkUnstructuredGrid> AppendedGrids(
  std::span<const vtkSmartPointer<vtkUnstructuredGrid>> grids);

/// Adds the arrays of rational weights and degrees to parts that lack them, so that they are kept.
/// The defaults mean ordinary cells: weights are 1, and degrees of 0 follow from the points.
void FillCellKinds(std::span<const vtkSmartPointer<vtkUnstructuredGrid>> grids);

/// A shallow copy of a grid with coefficients whose fields are replaced by their truncations. Point
/// and cell arrays with these names, which contain values of the whole fields, are left out.
[[nodiscard]] PIXELEXACTFILTERS_EXPORT vtkSmartPointer<vtkUnstructuredGrid> WithTruncated(
  vtkUnstructuredGrid* grid, std::span<const Truncation> truncations);
} // namespace pixelexact
#endif
