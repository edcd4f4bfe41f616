// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/ModelSource.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/GridConversion.h"
#include "Core/Base/Error.h"
#include "HighOrderArrays.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
bool IsPlain(const CompositePart& part)
{
  return !HasHighOrderArrays(part.grid);
}

vtkSmartPointer<vtkUnstructuredGrid> ConvertOne(
  vtkUnstructuredGrid* grid, KeptMesh& kept, vtkAlgorithm* owner, const std::string& where)
{
  auto converted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto report = ConvertGrid(grid, {}, kept, converted);
  for (const auto& line : report.diagnostics)
  {
    vtkWarningWithObjectMacro(owner, << where << line);
  }
  return converted;
}
} // namespace

ModelSource::ModelSource() = default;
ModelSource::~ModelSource() = default;

KeptMesh& ModelSource::Kept(std::size_t part)
{
  while (this->Meshes.size() <= part)
  {
    this->Meshes.push_back(std::make_unique<KeptMesh>());
  }
  return *this->Meshes[part];
}

vtkSmartPointer<vtkDataObject> ModelSource::Convert(vtkUnstructuredGrid* grid, vtkAlgorithm* owner)
{
  return HasHighOrderArrays(grid) ? nullptr : ConvertOne(grid, this->Kept(0), owner, "");
}

vtkSmartPointer<vtkDataObject> ModelSource::Convert(vtkCompositeDataSet* data, vtkAlgorithm* owner)
{
  const auto parts = PartsOf(data);
  if (std::ranges::none_of(parts, IsPlain))
  {
    return nullptr;
  }
  const auto converted = vtkSmartPointer<vtkCompositeDataSet>::Take(data->NewInstance());
  converted->CopyStructure(data);
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(data->NewIterator());
  std::size_t next = 0;
  for (leaf->InitTraversal(); leaf->IsDoneWithTraversal() == 0; leaf->GoToNextItem())
  {
    if (next == parts.size() || parts[next].flatIndex != leaf->GetCurrentFlatIndex())
    {
      continue;
    }
    const CompositePart& part = parts[next];
    try
    {
      const auto grid = IsPlain(part)
        ? ConvertOne(part.grid, this->Kept(next), owner, part.name + ": ")
        : vtkSmartPointer<vtkUnstructuredGrid>(part.grid);
      converted->SetDataSet(leaf, grid);
    }
    catch (const Error& error)
    {
      throw InvalidData(part.name + ": " + error.what());
    }
    ++next;
  }
  return converted;
}

std::shared_ptr<HighOrderModel> ModelSource::Get(vtkDataObject* data, vtkAlgorithm* owner)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!grid && !composite)
  {
    throw InvalidData("there is no high-order grid; connect a vtkUnstructuredGrid.");
  }
  const DataState state = StateOf(data);
  if (!this->Model || this->Source != state)
  {
    // The old model is held until the new one is made, which may share its locator.
    this->Source.clear();
    this->Converted = nullptr;
    this->Converted = grid ? this->Convert(grid, owner) : this->Convert(composite, owner);
    if (!this->Converted)
    {
      this->Meshes.clear();
    }
    this->Model = HighOrderModel::From(this->Converted ? this->Converted.Get() : data);
    this->Source = state;
  }
  return this->Model;
}

vtkDataObject* ModelSource::GridOf(vtkDataObject* data) const
{
  return this->Converted ? this->Converted.Get() : data;
}

void TakeGrids(vtkInformation* port)
{
  port->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

std::string ChosenName(vtkAlgorithm* filter, const std::string& given)
{
  if (!given.empty())
  {
    return given;
  }
  // GetInputArrayInformation(0) would create an entry where there is none.
  vtkInformationVector* arrays =
    filter->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* array = arrays != nullptr ? arrays->GetInformationObject(0) : nullptr;
  return array != nullptr && array->Has(vtkDataObject::FIELD_NAME())
    ? array->Get(vtkDataObject::FIELD_NAME())
    : "";
}

vtkSmartPointer<vtkUnstructuredGrid> WithCoefficients(
  vtkUnstructuredGrid* grid, vtkAlgorithm* owner)
{
  if (HasHighOrderArrays(grid))
  {
    return grid;
  }
  auto converted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  KeptMesh kept;
  for (const auto& line : ConvertGrid(grid, {}, kept, converted).diagnostics)
  {
    vtkWarningWithObjectMacro(owner, << line);
  }
  return converted;
}
} // namespace pixelexact
