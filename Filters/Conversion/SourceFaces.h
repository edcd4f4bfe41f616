// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceFaces_h
#define SourceFaces_h

#include "Core/Faces/AttributedFace.h"

#include <span>
#include <vector>

class vtkUnstructuredGrid;

namespace pixelexact
{
class SourceMesh;

/// FieldData, int64, three of a face with an attribute: the number of its cell in the grid, the
/// face as FacesOf(shape) counts, the attribute. For readers of formats whose cells VTK's readers
/// make.
inline constexpr const char* kSourceFaces = "PixelExactSourceFaces";

/// Adds that array; none for no faces. `element` in `faces` is the cell.
void AddSourceFaces(std::span<const AttributedFace> faces, vtkUnstructuredGrid* grid);

/// What the array of `grid` says of the elements of `mesh`. Throws InvalidData for an array of
/// other numbers.
std::vector<AttributedFace> SourceFacesOf(vtkUnstructuredGrid* grid, const SourceMesh& mesh);
} // namespace pixelexact
#endif
