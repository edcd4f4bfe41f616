// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/ModelSource.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/FollowedGrid.h"
#include "Conversion/GridConversion.h"
#include "ConversionLoss.h"
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
/// Why the grid's coefficients do not fit it; empty where they do. The caller may take the model.
std::string MisfitOf(vtkUnstructuredGrid* grid, std::shared_ptr<HighOrderModel>* model = nullptr)
{
  try
  {
    const auto made = HighOrderModel::From(grid);
    if (model != nullptr)
    {
      *model = made;
    }
    return {};
  }
  catch (const StaleData& error)
  {
    return error.what();
  }
}

vtkSmartPointer<vtkUnstructuredGrid> ConvertOne(
  vtkUnstructuredGrid* grid, KeptMesh& kept, vtkAlgorithm* owner, const std::string& where)
{
  vtkSmartPointer<vtkUnstructuredGrid> converted;
  std::vector<std::string> lines;
  if (HasSolverMesh(grid))
  {
    FollowedGrid followed = FollowGrid(grid);
    converted = followed.grid;
    lines = std::move(followed.notes);
  }
  else
  {
    const std::string misfit = HasHighOrderArrays(grid) ? MisfitOf(grid) : "";
    if (HasHighOrderArrays(grid) && misfit.empty())
    {
      return WithNewFields(grid);
    }
    if (!misfit.empty() && (HasSolverCoefficients(grid) || OrderLostByConversion(grid) >= 0))
    {
      throw StaleData(misfit);
    }
    converted = vtkSmartPointer<vtkUnstructuredGrid>::New();
    lines = ConvertGrid(grid, {}, kept, converted).diagnostics;
  }
  for (const auto& line : lines)
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
  return IsComplete(grid) ? nullptr : ConvertOne(grid, this->Kept(0), owner, "");
}

vtkSmartPointer<vtkDataObject> ModelSource::Convert(vtkCompositeDataSet* data, vtkAlgorithm* owner)
{
  const auto parts = PartsOf(data);
  std::vector<bool> complete;
  complete.reserve(parts.size());
  for (const CompositePart& part : parts)
  {
    complete.push_back(IsComplete(part.grid));
  }
  if (std::ranges::find(complete, false) == complete.end())
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
      const auto grid = complete[next]
        ? vtkSmartPointer<vtkUnstructuredGrid>(part.grid)
        : ConvertOne(part.grid, this->Kept(next), owner, part.name + ": ");
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
    // The old model is held until the new one is made, which may share its locator. So is that of
    // a grid that fits, which IsComplete makes.
    std::shared_ptr<HighOrderModel> fitting;
    if (HasHighOrderArrays(grid))
    {
      MisfitOf(grid, &fitting);
    }
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

bool IsComplete(vtkUnstructuredGrid* grid)
{
  return grid != nullptr && HasHighOrderArrays(grid) && MisfitOf(grid).empty() &&
    !HasNewPointArrays(grid);
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
  if (IsComplete(grid))
  {
    return grid;
  }
  KeptMesh kept;
  return ConvertOne(grid, kept, owner, "");
}
} // namespace pixelexact
