// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/CgnsFile.h"

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// Turns boundary conditions into attributes of the grid's faces, numbered from 1 in the order in
/// which their names first occur (SourceArrays.h). `grid` is JoinBlocks of `read`. Notes state
/// which conditions match no face of a cell.
void AddBoundaryConditions(const std::vector<CgnsZone>& zones, vtkMultiBlockDataSet& read,
  vtkUnstructuredGrid& grid, std::vector<std::string>& notes);
} // namespace pixelexact
