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

/// Returns all numeric arrays, or those with the given names, of PointData, then of CellData; an
/// array of PointData precedes one of CellData with the same name. Ids, ghost flags, weights and
/// degrees are left out unless named. Throws InvalidData for a name that does not exist.
FieldArrays SelectFields(vtkUnstructuredGrid* grid, const std::vector<std::string>& names);

class SourceMesh;

/// FieldData, int64, three of a face with an attribute: the number of its cell in the grid, the
/// face as FacesOf(shape) counts, the attribute. For readers of formats whose cells VTK's readers
/// make.
inline constexpr const char* kSourceFaces = "PixelExactSourceFaces";

/// Adds that array; none for no faces. `element` in `faces` is the cell.
void AddSourceFaces(std::span<const AttributedFace> faces, vtkUnstructuredGrid* grid);

/// The attributes of elements' faces in the array of `grid`. Throws InvalidData for an array with
/// another number of values.
std::vector<AttributedFace> SourceFacesOf(vtkUnstructuredGrid* grid, const SourceMesh& mesh);
} // namespace pixelexact
#endif
