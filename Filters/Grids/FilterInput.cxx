// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/FilterInput.h"

#include "CompositeParts.h"
#include "Core/Base/Error.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <algorithm>
#include <iterator>

namespace pixelexact
{
std::vector<const Field*> FieldsNamed(
  const HighOrderModel& model, const std::vector<std::string>& names)
{
  std::vector<const Field*> fields;
  std::ranges::transform(names, std::back_inserter(fields),
    [&model](const std::string& name) { return &model.GetField(name); });
  if (names.empty())
  {
    for (const auto& field : model.Fields())
    {
      fields.push_back(&field);
    }
    for (const auto& [name, text] : model.Definitions())
    {
      fields.push_back(&model.GetField(name));
    }
  }
  return fields;
}

void PrintFields(ostream& os, vtkIndent indent, const std::vector<std::string>& names)
{
  os << indent << "Fields:";
  for (const auto& name : names)
  {
    os << " " << name;
  }
  os << (names.empty() ? " all\n" : "\n");
}

std::array<double, 6> BoundsOf(vtkDataObject* data)
{
  std::array<double, 6> bounds;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    composite->GetBounds(bounds.data());
  }
  else
  {
    vtkUnstructuredGrid::SafeDownCast(data)->GetBounds(bounds.data());
  }
  return bounds;
}

void MakeOutputLikeInput(vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* given = vtkDataObject::GetData(input[0]);
  vtkDataObject* made = vtkDataObject::GetData(output);
  if (given != nullptr && (made == nullptr || !made->IsA(given->GetClassName())))
  {
    const auto fresh = vtkSmartPointer<vtkDataObject>::Take(given->NewInstance());
    output->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), fresh);
  }
}

void ForLeafGrids(vtkDataObject* input, vtkDataObject* output,
  const std::function<vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid*)>& made)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
  {
    // Processes without a share of the data have an empty one.
    output->ShallowCopy(grid->GetNumberOfCells() > 0 ? made(grid).Get() : grid);
    return;
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  auto* copy = vtkCompositeDataSet::SafeDownCast(output);
  if (composite == nullptr || copy == nullptr)
  {
    throw InvalidData("there is no high-order grid; connect a vtkUnstructuredGrid.");
  }
  copy->CopyStructure(composite);
  const auto parts = PartsOf(composite);
  std::size_t next = 0;
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaf->InitTraversal(); leaf->IsDoneWithTraversal() == 0; leaf->GoToNextItem())
  {
    if (next == parts.size() || parts[next].flatIndex != leaf->GetCurrentFlatIndex())
    {
      copy->SetDataSet(leaf, leaf->GetCurrentDataObject());
      continue;
    }
    try
    {
      copy->SetDataSet(leaf, made(parts[next].grid));
    }
    catch (const Error& error)
    {
      throw InvalidData(parts[next].name + ": " + error.what());
    }
    ++next;
  }
}
} // namespace pixelexact
