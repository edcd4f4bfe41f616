// SPDX-License-Identifier: BSD-3-Clause
#ifndef SourceArrays_h
#define SourceArrays_h

#include "Core/Faces/AttributedFace.h"

#include <span>
#include <string>
#include <vector>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace pixelexact
{
/// The numeric arrays that make fields.
struct FieldArrays
{
  std::vector<vtkDataArray*> points;
  std::vector<vtkDataArray*> cells;
};

/// All numeric arrays, or those of the given names, of PointData, then of CellData; where both have
/// a name, that of PointData. Left out unless named: ids, ghost flags, weights and degrees. Throws
/// InvalidData for a name that is not there.
FieldArrays SelectFields(vtkUnstructuredGrid* grid, const std::vector<std::string>& names);

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
