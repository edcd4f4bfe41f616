// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellArrays_h
#define CellArrays_h

#include "HighOrderModel.h"

#include <span>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// Gives the cells of `output` the cell arrays of a model's grid, or of composite data those that
/// all its leaves have alike: cell i those of the cell of element elementOf[i]. PixelExact's own
/// are left out, and those whose name the output has. Also the grid's field data, without
/// PixelExact's.
void SpreadCellArrays(vtkDataObject* grid, const HighOrderModel& model,
  std::span<const int> elementOf, vtkUnstructuredGrid* output);

/// That it takes for a cell, about.
[[nodiscard]] double BytesOfCellArrays(vtkDataObject* grid);
} // namespace pixelexact
#endif
