// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/SourceArrays.h"

#include "Conversion/SourceMesh.h"
#include "ConversionLoss.h"
#include "Core/Base/Error.h"
#include "Core/Shape/ShapeFace.h"
#include "HighOrderArrays.h"
#include "HighOrderModel.h"
#include "PackedArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationQuadratureSchemeDefinitionVectorKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkQuadratureSchemeDefinition.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <set>
#include <unordered_map>

namespace pixelexact
{
namespace
{
/// Whether an array states where the values at a cell's quadrature points begin.
bool IsQuadratureOffset(vtkDataArray* array)
{
  return array->HasInformation() &&
    array->GetInformation()->Has(vtkQuadratureSchemeDefinition::DICTIONARY());
}

class Selection
{
public:
  Selection(const std::vector<std::string>& names)
    : Names(names.begin(), names.end())
  {
  }

  std::vector<vtkDataArray*> From(vtkDataSetAttributes* data)
  {
    std::vector<vtkDataArray*> chosen;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i); // null where not numeric
      const std::string name = array && array->GetName() ? array->GetName() : "";
      if (!name.empty() && array->GetNumberOfComponents() > 0 && Wanted(data, array, name) &&
        Taken.insert(name).second)
      {
        chosen.push_back(array);
      }
    }
    return chosen;
  }

  void RequireAll(vtkUnstructuredGrid* grid) const
  {
    for (const auto& name : Names)
    {
      if (!Taken.contains(name))
      {
        std::string known;
        for (vtkDataSetAttributes* data :
          { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
            static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
        {
          for (int i = 0; i < data->GetNumberOfArrays(); ++i)
          {
            known += std::string(known.empty() ? "" : ", ") +
              (data->GetArrayName(i) ? data->GetArrayName(i) : "");
          }
        }
        throw InvalidData("the grid has no numeric array '" + name +
          "'; it has: " + (known.empty() ? "none" : known) + ".");
      }
    }
  }

private:
  [[nodiscard]] bool Wanted(
    vtkDataSetAttributes* data, vtkDataArray* array, const std::string& name) const
  {
    if (!Names.empty())
    {
      return Names.contains(name);
    }
    static const std::set<std::string> bookkeeping{ vtkDataSetAttributes::GhostArrayName(),
      "vtkOriginalPointIds", "vtkOriginalCellIds", "RationalWeights", "HigherOrderDegrees",
      kElementIds, kSourceCells, kInnerFaces, kLinearizedOrder };
    return !bookkeeping.contains(name) && !name.starts_with(kPackedPrefix) &&
      !IsQuadratureOffset(array) && array != data->GetGlobalIds() &&
      array != data->GetPedigreeIds() && array != data->GetRationalWeights() &&
      array != data->GetHigherOrderDegrees();
  }

  std::set<std::string> Names;
  std::set<std::string> Taken;
};

constexpr int kNumbers = 3;
} // namespace

FieldArrays SelectFields(vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  Selection selection(names);
  FieldArrays fields;
  fields.points = selection.From(grid->GetPointData());
  fields.cells = selection.From(grid->GetCellData());
  selection.RequireAll(grid);
  return fields;
}

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
