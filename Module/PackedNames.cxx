// SPDX-License-Identifier: BSD-3-Clause
#include "PackedNames.h"

#include "HighOrderArrays.h"
#include "PackedCheck.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <set>

namespace pixelexact
{
namespace packing
{
std::vector<vtkSmartPointer<vtkAbstractArray>> FixedArrays(vtkFieldData* data)
{
  static const std::set<std::string> kOfElements{ "Spaces", "Space", "Offset", "Coefficients",
    "Centre", "Size", "Uncertainty", "SourceCell", "Fingerprint", "Origin", "Components", "Mapping",
    "Element", "Face", "Attribute" };
  std::vector<vtkSmartPointer<vtkAbstractArray>> fixed;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if ((name.starts_with(kMeshPrefix) || name.starts_with(kFieldPrefix)) &&
      !kOfElements.contains(name.substr(name.rfind('.') + 1)))
    {
      fixed.emplace_back(array);
    }
  }
  return fixed;
}

vtkSmartPointer<vtkUnstructuredGrid> BareCopy(vtkUnstructuredGrid* grid, bool keepIds)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  copy->ShallowCopy(grid);
  vtkNew<vtkFieldData> fieldData;
  fieldData->ShallowCopy(grid->GetFieldData());
  copy->SetFieldData(fieldData);
  const auto fixed = FixedArrays(grid->GetFieldData());
  const vtkSmartPointer<vtkAbstractArray> ids = grid->GetCellData()->GetAbstractArray(kElementIds);
  RemoveHighOrderArrays(copy);
  for (const auto& array : fixed)
  {
    copy->GetFieldData()->AddArray(array);
  }
  if (keepIds && ids)
  {
    copy->GetCellData()->AddArray(ids);
  }
  return copy;
}
} // namespace packing

using namespace packing;

bool IsPacked(vtkUnstructuredGrid* grid)
{
  return grid->GetCellData()->HasArray((kMesh + "Space").c_str()) != 0 ||
    grid->GetCellData()->HasArray((kMesh + "Marks").c_str()) != 0;
}

std::vector<std::string> PackedFieldNames(vtkUnstructuredGrid* grid)
{
  const std::string suffix = ".Marks";
  // Sorts by the stored places, because filters and files reorder arrays.
  std::multimap<double, std::string> byPlace;
  vtkCellData* data = grid->GetCellData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* arrayName = data->GetArrayName(i);
    const std::string name = arrayName ? arrayName : "";
    if (name.starts_with(kField) && name.ends_with(suffix) &&
      name.size() > kField.size() + suffix.size())
    {
      const std::string field =
        name.substr(kField.size(), name.size() - kField.size() - suffix.size());
      vtkDataArray* space = data->GetArray((FieldName(field) + "Space").c_str());
      const bool isThere = space != nullptr && space->GetNumberOfTuples() > 0 &&
        space->GetNumberOfComponents() == kPackedSpace;
      byPlace.emplace(isThere ? space->GetComponent(0, kPackedSpace - 1) : 0.0, field);
    }
  }
  std::vector<std::string> names;
  for (const auto& [place, field] : byPlace)
  {
    names.push_back(field);
  }
  return names;
}
} // namespace pixelexact
