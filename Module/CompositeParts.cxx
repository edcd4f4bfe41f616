// SPDX-License-Identifier: BSD-3-Clause
#include "CompositeParts.h"

#include "Core/Base/Error.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace pixelexact
{
namespace
{
std::string NameOf(vtkCompositeDataIterator* leaf)
{
  std::string name = "block " + std::to_string(leaf->GetCurrentFlatIndex());
  if (leaf->HasCurrentMetaData() != 0)
  {
    const char* given = leaf->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
    name += given != nullptr ? " ('" + std::string(given) + "')" : "";
  }
  return name;
}
} // namespace

std::vector<CompositePart> PartsOf(vtkCompositeDataSet* data)
{
  std::vector<CompositePart> parts;
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(data->NewIterator());
  for (leaf->InitTraversal(); leaf->IsDoneWithTraversal() == 0; leaf->GoToNextItem())
  {
    vtkDataObject* object = leaf->GetCurrentDataObject();
    if (object->GetNumberOfElements(vtkDataObject::CELL) == 0)
    {
      continue; // processes without a share of the data have an empty one
    }
    auto* grid = vtkUnstructuredGrid::SafeDownCast(object);
    if (grid == nullptr)
    {
      throw InvalidData(NameOf(leaf) + " is a " + object->GetClassName() +
        "; leave it out (vtkExtractBlock), only vtkUnstructuredGrids have high-order fields.");
    }
    parts.push_back({ grid, leaf->GetCurrentFlatIndex(), NameOf(leaf) });
  }
  return parts;
}

DataState StateOf(vtkDataObject* data)
{
  DataState state{ { data, data->GetMTime() } };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    for (const CompositePart& part : PartsOf(composite))
    {
      state.emplace_back(part.grid, part.grid->GetMTime());
    }
  }
  return state;
}
} // namespace pixelexact
