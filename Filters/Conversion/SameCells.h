// SPDX-License-Identifier: BSD-3-Clause
#ifndef SameCells_h
#define SameCells_h

#include "vtkType.h"

#include <compare>
#include <span>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
/// A cell of one of several grids.
struct CellPlace
{
  std::size_t grid = 0;
  vtkIdType cell = 0;

  auto operator<=>(const CellPlace&) const = default;
};

/// Finds cells at the same place. Each group has two or more cells, in the order of the grids and
/// their cells. Cells are the same where they have the same type and number of points, and where
/// the boxes and the means of their corners agree up to roundings of the coordinates. Points,
/// lines, cells without points and cells of types unknown to VTK are in no group. Parallel; the
/// time grows as N log N with the number of cells.
std::vector<std::vector<CellPlace>> SameCells(std::span<vtkUnstructuredGrid* const> grids);
} // namespace pixelexact
#endif
