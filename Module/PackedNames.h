// SPDX-License-Identifier: BSD-3-Clause
#ifndef PackedNames_h
#define PackedNames_h

#include "PackedArrays.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkFieldData;

// What packing and unpacking share.
namespace pixelexact::packing
{
inline const std::string kMesh = std::string(kPackedPrefix) + "Mesh.";
inline const std::string kField = std::string(kPackedPrefix) + "Field.";
inline const std::string kBoundary = kMesh + "Boundary";

/// What the names of a field's packed arrays begin with.
inline std::string FieldName(const std::string& field)
{
  return kField + field + ".";
}

/// Arrays of ours that are not of elements: names of bases, a plane mesh's slab.
std::vector<vtkSmartPointer<vtkAbstractArray>> FixedArrays(vtkFieldData* data);

/// A copy whose lists of arrays are its own, with our fixed arrays alone and, where it is to keep
/// them, the elements' numbers.
vtkSmartPointer<vtkUnstructuredGrid> BareCopy(vtkUnstructuredGrid* grid, bool keepIds);
} // namespace pixelexact::packing
#endif
