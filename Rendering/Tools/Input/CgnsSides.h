// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/CgnsFile.h"

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// Makes boundary conditions attributes of the grid's faces, numbered from 1 as their names first
/// occur (SourceArrays.h). `grid` is JoinBlocks of `read`. What names no face of a cell is told in
/// a note.
void AddBoundaryConditions(const std::vector<CgnsZone>& zones, vtkMultiBlockDataSet& read,
  vtkUnstructuredGrid& grid, std::vector<std::string>& notes);
} // namespace pixelexact
