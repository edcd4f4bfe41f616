// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/ExodusFile.h"

class vtkUnstructuredGrid;

namespace pixelexact
{
/// CellData, int64: the element of a cell, in the file's order, from 1.
inline constexpr const char* kExodusElement = "PixelExactExodusElement";

/// Makes side sets attributes of the grid's faces (SourceFaces.h). Its cells have kExodusElement.
/// What names no face of a cell is counted in a note.
void AddSideSets(const std::vector<ExodusFile::SideSet>& sets, vtkUnstructuredGrid& grid,
  std::vector<std::string>& notes);
} // namespace pixelexact
