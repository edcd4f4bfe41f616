// SPDX-License-Identifier: BSD-3-Clause
// What ParaView's selections tell of the cells that are seen.
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
/// The same cells with numbers of the cells of `input`; the grid itself where its source cells,
/// which are told anyhow, have these.
vtkSmartPointer<vtkUnstructuredGrid> Numbered(
  vtkUnstructuredGrid* grid, vtkUnstructuredGrid* input, bool isPart)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  vtkDataArray* source =
    grid->GetFieldData()->GetArray((std::string(pixelexact::kMeshPrefix) + "SourceCell").c_str());
  const bool isKnown = source != nullptr && source->GetNumberOfTuples() == cells;
  // Of plain grids some cells are left out, and then source cells are the plain grid's.
  const bool isWhole = input == nullptr || input->GetNumberOfCells() == cells || !isKnown;
  const auto sourceOf = [source](vtkIdType cell)
  { return static_cast<vtkIdType>(source->GetTuple1(cell)); };
  bool isTold = isKnown && !isPart;
  for (vtkIdType cell = 0; isTold && isWhole && cell < cells; ++cell)
  {
    isTold = sourceOf(cell) == cell;
  }
  if (isTold)
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
  // Elements of other processes may come before a part's own.
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
