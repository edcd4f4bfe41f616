// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/FilterInput.h"

#include "CompositeParts.h"
#include "Core/Base/Error.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace pixelexact
{
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
