// SPDX-License-Identifier: BSD-3-Clause
#ifndef BoundaryArrays_h
#define BoundaryArrays_h

#include "CellElements.h"
#include "Core/Faces/AttributedFace.h"

namespace pixelexact
{
/// Reads the faces with attributes from a grid's arrays, for the cells that it still has, as
/// elements of `mesh`, in ascending order, each once. Empty where there are no such arrays. Throws
/// InvalidData, naming the array, where one is missing, of wrong type or size, or contains a number
/// that is no face.
std::vector<AttributedFace> ReadBoundary(
  vtkUnstructuredGrid* grid, const Mesh& mesh, const CellElements& cells, vtkIdType elements);
} // namespace pixelexact
#endif
