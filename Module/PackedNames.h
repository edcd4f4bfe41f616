// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackedNames_h
#define PackedNames_h

#include "PackedArrays.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkFieldData;

// Names and arrays that packing and unpacking share.
namespace pixelexact::packing
{
inline const std::string kMesh = std::string(kPackedPrefix) + "Mesh.";
inline const std::string kField = std::string(kPackedPrefix) + "Field.";
inline const std::string kBoundary = kMesh + "Boundary";

/// The prefix of the names of a field's packed arrays.
inline std::string FieldName(const std::string& field)
{
  return kField + field + ".";
}

/// PixelExact's arrays that do not belong to elements: names of bases, the slab of a plane mesh.
std::vector<vtkSmartPointer<vtkAbstractArray>> FixedArrays(vtkFieldData* data);

/// Returns a copy of the grid with its own lists of arrays: PixelExact's fixed arrays alone and,
/// with `keepIds`, the elements' numbers.
vtkSmartPointer<vtkUnstructuredGrid> BareCopy(vtkUnstructuredGrid* grid, bool keepIds);
} // namespace pixelexact::packing
#endif
