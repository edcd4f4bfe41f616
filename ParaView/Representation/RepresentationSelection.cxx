// SPDX-License-Identifier: BSD-3-Clause
// Numbers of visible cells for ParaView's selections.
#include "RepresentationInternals.h"

#include "HighOrderArrays.h"
#include "HighOrderModel.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace
{
/// A copy of the grid whose cells have the numbers of the cells of `input`; the grid itself where
/// its source cells, which selections always contain, have these numbers.
vtkSmartPointer<vtkUnstructuredGrid> Numbered(
  vtkUnstructuredGrid* grid, vtkUnstructuredGrid* input, bool isPart)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  vtkDataArray* source =
    grid->GetFieldData()->GetArray((std::string(pixelexact::kMeshPrefix) + "SourceCell").c_str());
  const bool isKnown = source != nullptr && source->GetNumberOfTuples() == cells;
  // If cells of a plain grid were left out, source cells have the plain grid's numbers.
  const bool isWhole = input == nullptr || input->GetNumberOfCells() == cells || !isKnown;
  const auto sourceOf = [source](vtkIdType cell)
  { return static_cast<vtkIdType>(source->GetTuple1(cell)); };
  bool isSame = isKnown && !isPart;
  for (vtkIdType cell = 0; isSame && isWhole && cell < cells; ++cell)
  {
    isSame = sourceOf(cell) == cell;
  }
  if (isSame)
  {
    return grid;
  }
  vtkNew<vtkTypeInt64Array> numbers;
  numbers->SetName(pixelexact::kSelectedCells);
  numbers->SetNumberOfValues(cells);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    numbers->SetValue(cell, isWhole ? cell : sourceOf(cell));
  }
  auto numbered = vtkSmartPointer<vtkUnstructuredGrid>::Take(grid->NewInstance());
  numbered->ShallowCopy(grid);
  numbered->GetCellData()->AddArray(numbers);
  return numbered;
}
} // namespace

//------------------------------------------------------------------------------
void vtkPixelExactRepresentation::Internals::NumberSelectedCells(vtkDataObject* data)
{
  // Elements of other processes may precede those of a part.
  const bool isPart = HasSeveralProcesses();
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(Shown))
  {
    Shown = Numbered(grid, vtkUnstructuredGrid::SafeDownCast(data), isPart);
    return;
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(Shown);
  auto* input = vtkCompositeDataSet::SafeDownCast(data);
  if (composite == nullptr || input == nullptr)
  {
    return;
  }
  const auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaf->InitTraversal(); leaf->IsDoneWithTraversal() == 0; leaf->GoToNextItem())
  {
    vtkDataObject* found = leaf->GetCurrentDataObject();
    auto* grid = vtkUnstructuredGrid::SafeDownCast(found);
    copy->SetDataSet(leaf,
      grid == nullptr
        ? found
        : Numbered(grid, vtkUnstructuredGrid::SafeDownCast(input->GetDataSet(leaf)), isPart).Get());
  }
  Shown = copy;
}
