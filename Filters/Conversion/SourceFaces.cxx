// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/SourceFaces.h"

#include "Conversion/SourceMesh.h"
#include "Core/Base/Error.h"
#include "Core/Shape/ShapeFace.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <unordered_map>

namespace pixelexact
{
namespace
{
constexpr int kNumbers = 3;
} // namespace

void AddSourceFaces(std::span<const AttributedFace> faces, vtkUnstructuredGrid* grid)
{
  if (faces.empty())
  {
    return;
  }
  vtkNew<vtkTypeInt64Array> array;
  array->SetName(kSourceFaces);
  array->SetNumberOfComponents(kNumbers);
  for (const AttributedFace& entry : faces)
  {
    const vtkTypeInt64 numbers[kNumbers] = { entry.face.element, entry.face.face, entry.attribute };
    array->InsertNextTypedTuple(numbers);
  }
  grid->GetFieldData()->AddArray(array);
}

std::vector<AttributedFace> SourceFacesOf(vtkUnstructuredGrid* grid, const SourceMesh& mesh)
{
  auto* array =
    vtkTypeInt64Array::SafeDownCast(grid->GetFieldData()->GetAbstractArray(kSourceFaces));
  if (array == nullptr)
  {
    return {};
  }
  if (array->GetNumberOfComponents() != kNumbers)
  {
    throw InvalidData(std::string("the field array '") + kSourceFaces +
      "' should have three components: cell, face, attribute.");
  }
  std::unordered_map<std::int64_t, int> elementOf;
  for (int e = 0; e < mesh.Elements(); ++e)
  {
    elementOf.emplace(mesh.Number(e), e);
  }
  std::vector<AttributedFace> faces;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    vtkTypeInt64 numbers[kNumbers];
    array->GetTypedTuple(i, numbers);
    const auto element = elementOf.find(numbers[0]);
    if (element == elementOf.end())
    {
      continue; // of a cell that is no element here
    }
    const auto count =
      static_cast<vtkTypeInt64>(FacesOf(mesh.Basis(element->second).GetSpace().shape).size());
    if (numbers[1] < 0 || numbers[1] >= count)
    {
      throw InvalidData(std::string("the field array '") + kSourceFaces + "' names face " +
        std::to_string(numbers[1]) + " of cell " + std::to_string(numbers[0]) + ", which has " +
        std::to_string(count) + ".");
    }
    faces.push_back(
      { { element->second, static_cast<int>(numbers[1]) }, static_cast<std::int32_t>(numbers[2]) });
  }
  return faces;
}
} // namespace pixelexact
