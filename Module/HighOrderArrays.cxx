// SPDX-License-Identifier: BSD-3-Clause
#include "HighOrderArrays.h"

#include "ArrayViews.h"
#include "Core/Base/Error.h"
#include "Fingerprint.h"
#include "PackedArrays.h"
#include "PackedCheck.h"
#include "PackedNames.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
template <class Array, class T>
void Add(vtkFieldData* data, const std::string& name, std::span<const T> values, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::ranges::copy(values, array->GetPointer(0));
  data->AddArray(array);
}

/// The array takes over the coefficients.
void AddCoefficients(vtkFieldData* data, const std::string& prefix, CoefficientBlock coefficients)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName((prefix + "Coefficients").c_str());
  const auto size = static_cast<vtkIdType>(coefficients.size());
  array->SetArray(coefficients.Release(), size, 0, vtkDoubleArray::VTK_DATA_ARRAY_FREE);
  data->AddArray(array);
}

void AddExpansion(
  vtkFieldData* data, const std::string& prefix, OwnedExpansion expansion, Origin origin)
{
  std::vector<unsigned char> spaces;
  for (const auto& space : expansion.spaces)
  {
    spaces.insert(spaces.end(),
      { static_cast<unsigned char>(space.shape), static_cast<unsigned char>(space.form),
        space.order[0], space.order[1], space.order[2] });
  }
  Add<vtkUnsignedCharArray, unsigned char>(data, prefix + "Spaces", spaces, 5);
  Add<vtkIntArray, std::int32_t>(data, prefix + "Space", expansion.spaceOf);
  Add<vtkTypeInt64Array, std::int64_t>(data, prefix + "Offset", expansion.offset);
  const auto kind = static_cast<unsigned char>(origin);
  Add<vtkUnsignedCharArray, unsigned char>(data, prefix + "Origin", { &kind, 1 });
  AddCoefficients(data, prefix, std::move(expansion.coefficients));
}

void AddBoundary(vtkFieldData* data, std::span<const AttributedFace> boundary)
{
  if (boundary.empty())
  {
    return;
  }
  std::vector<std::int64_t> elements;
  std::vector<std::int32_t> faces;
  std::vector<std::int32_t> attributes;
  for (const AttributedFace& entry : boundary)
  {
    elements.push_back(entry.face.element);
    faces.push_back(entry.face.face);
    attributes.push_back(entry.attribute);
  }
  const std::string prefix = kBoundaryPrefix;
  Add<vtkTypeInt64Array, std::int64_t>(data, prefix + "Element", elements);
  Add<vtkIntArray, std::int32_t>(data, prefix + "Face", faces);
  Add<vtkIntArray, std::int32_t>(data, prefix + "Attribute", attributes);
}

void RemovePrefix(vtkFieldData* data, const std::string& prefix)
{
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const char* name = data->GetArrayName(i);
    if (name && std::string(name).starts_with(prefix))
    {
      data->RemoveArray(name);
    }
  }
}
} // namespace

bool HasHighOrderArrays(vtkUnstructuredGrid* grid)
{
  return grid && grid->GetFieldData() &&
    (grid->GetFieldData()->HasArray((std::string(kMeshPrefix) + "Coefficients").c_str()) ||
      IsPacked(grid));
}

bool IsShell(vtkUnstructuredGrid* grid)
{
  vtkDataArray* const slab = grid->GetFieldData()->GetArray(kSlab);
  return slab != nullptr && slab->GetNumberOfValues() == 1;
}

void RemoveHighOrderArrays(vtkUnstructuredGrid* grid)
{
  RemovePrefix(grid->GetFieldData(), kMeshPrefix);
  RemovePrefix(grid->GetFieldData(), kFieldPrefix);
  RemovePrefix(grid->GetCellData(), kPackedPrefix);
  grid->GetCellData()->RemoveArray(kElementIds);
}

void StoreMesh(vtkUnstructuredGrid* grid, MeshArrays mesh, Origin origin)
{
  StoreMesh(grid, std::move(mesh), origin, CellFingerprints(grid));
}

void StoreMesh(vtkUnstructuredGrid* grid, MeshArrays mesh, Origin origin,
  std::span<const std::int64_t> fingerprints)
{
  const auto cells = static_cast<std::size_t>(grid->GetNumberOfCells());
  if (mesh.map.spaceOf.size() != cells || mesh.sourceCell.size() != cells)
  {
    throw InvalidData("a mesh of " + std::to_string(mesh.map.spaceOf.size()) +
      " elements cannot be stored in a grid of " + std::to_string(cells) +
      " cells; give it one cell per element.");
  }
  RemoveHighOrderArrays(grid);
  vtkFieldData* data = grid->GetFieldData();
  const std::string prefix = kMeshPrefix;
  AddExpansion(data, prefix, std::move(mesh.map), origin);
  Add<vtkDoubleArray, double>(data, prefix + "Centre", mesh.centre, 3);
  Add<vtkDoubleArray, double>(data, prefix + "Size", mesh.size);
  Add<vtkDoubleArray, double>(data, prefix + "Uncertainty", mesh.uncertainty);
  Add<vtkTypeInt64Array, std::int64_t>(data, prefix + "SourceCell", mesh.sourceCell);
  AddBoundary(data, mesh.boundary);
  Add<vtkTypeInt64Array, std::int64_t>(data, prefix + "Fingerprint", fingerprints);

  vtkNew<vtkTypeInt64Array> ids;
  ids->SetName(kElementIds);
  ids->SetNumberOfValues(grid->GetNumberOfCells());
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    ids->SetValue(i, i);
  }
  grid->GetCellData()->AddArray(ids);
}

bool StoredMeshFits(vtkUnstructuredGrid* grid)
{
  ArrayKeeper keeper;
  const auto then = ViewArray<std::int64_t>(
    grid, std::string(kMeshPrefix) + "Fingerprint", 1, grid->GetNumberOfCells(), keeper);
  return std::ranges::equal(CellFingerprints(grid), then);
}

void StoreField(
  vtkUnstructuredGrid* grid, const std::string& name, FieldExpansion field, Origin origin)
{
  if (origin == Origin::Coefficients)
  {
    StoreField(grid, name, std::move(field), origin, {});
    return;
  }
  vtkDataArray* source = FieldSource(grid, name, origin);
  if (!source)
  {
    throw InvalidData("field '" + name + "' cannot be stored with values at points or of cells: " +
      "the grid has no such array of that name; add the array first.");
  }
  StoreField(grid, name, std::move(field), origin, ValueFingerprints(grid, source, origin));
}

void StoreField(vtkUnstructuredGrid* grid, const std::string& name, FieldExpansion field,
  Origin origin, std::span<const std::int64_t> fingerprints)
{
  vtkFieldData* data = grid->GetFieldData();
  const std::string prefix = kFieldPrefix + name + ".";
  // AddArray replaces an array of the same name; of those of an earlier version only these might be
  // left over.
  data->RemoveArray((prefix + "Fingerprint").c_str());
  data->RemoveArray((prefix + "Mapping").c_str());
  const std::int32_t components = field.values.components;
  AddExpansion(data, prefix, std::move(field.values), origin);
  if (field.mapping != Mapping::Identity)
  {
    const auto mapping = static_cast<unsigned char>(field.mapping);
    Add<vtkUnsignedCharArray, unsigned char>(data, prefix + "Mapping", { &mapping, 1 });
  }
  Add<vtkIntArray, std::int32_t>(data, prefix + "Components", { &components, 1 });
  if (origin != Origin::Coefficients)
  {
    Add<vtkTypeInt64Array, std::int64_t>(data, prefix + "Fingerprint", fingerprints);
  }
}

bool HasNamesake(vtkUnstructuredGrid* grid, const std::string& field, bool ofPoints)
{
  vtkDataSetAttributes* const data =
    ofPoints ? static_cast<vtkDataSetAttributes*>(grid->GetPointData()) : grid->GetCellData();
  const bool isPacked = IsPacked(grid);
  vtkDataArray* const origins = isPacked
    ? grid->GetCellData()->GetArray((packing::FieldName(field) + "Space").c_str())
    : grid->GetFieldData()->GetArray((kFieldPrefix + field + ".Origin").c_str());
  const int component = isPacked ? kPackedOrigin : 0;
  if (origins == nullptr || origins->GetNumberOfTuples() == 0 ||
    origins->GetNumberOfComponents() <= component || data->GetArray(field.c_str()) == nullptr)
  {
    return false;
  }
  const auto origin = static_cast<Origin>(static_cast<int>(origins->GetComponent(0, component)));
  return origin != Origin::Coefficients && IsAtPoints(origin) != ofPoints;
}

std::vector<std::string> StoredFieldNames(vtkUnstructuredGrid* grid)
{
  const std::string prefix = kFieldPrefix;
  const std::string suffix = ".Coefficients";
  std::vector<std::string> names;
  vtkFieldData* data = grid->GetFieldData();
  for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
  {
    const char* arrayName = data->GetArrayName(i);
    const std::string name = arrayName ? arrayName : "";
    if (name.starts_with(prefix) && name.ends_with(suffix) &&
      name.size() > prefix.size() + suffix.size())
    {
      names.push_back(name.substr(prefix.size(), name.size() - prefix.size() - suffix.size()));
    }
  }
  if (names.empty())
  {
    names = PackedFieldNames(grid);
  }
  return names;
}
} // namespace pixelexact
