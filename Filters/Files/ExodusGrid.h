// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExodusGrid_h
#define ExodusGrid_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// The times of an Exodus II file. Throws Error, naming the file.
std::vector<double> ExodusTimes(const std::string& file);

/// Reads the parts of a mesh, whose files are given in their order, at a time step of theirs,
/// counted from 0. Parts follow one another; within one, blocks share their nodes. Coordinates have
/// the file's precision. Fields are those of all nodes and elements, NaN where a block or a part
/// has no values of them; element blocks are the cell array "Attribute", and side sets attributes
/// of faces (SourceArrays.h). Shells become cells of two dimensions. Elements that are neither
/// solids nor of a surface become cells of lower dimension, or are left out. What is left out, or
/// has no values, is noted, with `surfaces` of the elements of surfaces. Throws Error, naming the
/// file.
vtkSmartPointer<vtkUnstructuredGrid> ReadExodusGrid(const std::vector<std::string>& files,
  std::size_t step, bool surfaces, std::vector<std::string>& notes);
} // namespace pixelexact
#endif
