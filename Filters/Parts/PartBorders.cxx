// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/PartBorders.h"

#include "Core/Base/Error.h"
#include "Grids/GridCopies.h"
#include "HighOrderModel.h"
#include "PackedArrays.h"
#include "Parts/BareElements.h"
#include "Parts/CommonWidths.h"
#include "Parts/PartExchange.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <exception>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// The cells whose points' boxes, made thrice as large, meet the box.
std::vector<vtkIdType> CellsNear(vtkUnstructuredGrid* grid, const vtkBoundingBox& here)
{
  std::vector<vtkIdType> near;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    grid->GetCellBounds(cell, bounds);
    vtkBoundingBox box(bounds);
    box.Inflate(box.GetMaxLength());
    if (here.Intersects(box))
    {
      near.push_back(cell);
    }
  }
  return near;
}

/// VTK's marks of a grid's cells.
std::vector<unsigned char> MarksOf(vtkUnstructuredGrid* grid)
{
  std::vector<unsigned char> marks(static_cast<std::size_t>(grid->GetNumberOfCells()), 0);
  if (vtkUnsignedCharArray* given = grid->GetCellGhostArray())
  {
    std::copy_n(given->GetPointer(0), marks.size(), marks.begin());
  }
  return marks;
}
} // namespace

Grid WithNeighbours(vtkUnstructuredGrid* grid, vtkMultiProcessController* processes)
{
  const bool any = grid->GetNumberOfCells() > 0;
  std::shared_ptr<HighOrderModel> model;
  Grid sent = Grid::New();
  std::string problem;
  try
  {
    if (any)
    {
      model = HighOrderModel::From(grid);
      std::vector<vtkIdType> bare = BareElements(*model, InnerOfAll(*model));
      std::erase_if(bare, [&](vtkIdType e) { return model->IsGhost(static_cast<int>(e)); });
      sent = PackedCells(grid, bare, true);
    }
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  AgreeThatAllIsWell(problem, processes);
  const PackedWidths widths = CommonWidths(any ? WidthsFor(grid) : PackedWidths(), processes);
  const std::vector<Grid> parts = FromAll(sent, processes);
  if (!any)
  {
    return grid;
  }
  const vtkBoundingBox here = BoxAround(*model);
  const auto own = static_cast<std::size_t>(processes->GetLocalProcessId());
  std::vector<Grid> near;
  std::vector<unsigned char> marks;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    if (p == own)
    {
      near.push_back(Pack(grid, widths));
      std::ranges::copy(MarksOf(grid), std::back_inserter(marks));
    }
    else if (const auto cells = CellsNear(parts[p], here); !cells.empty())
    {
      near.push_back(Pack(ExtractedCells(parts[p], cells), widths));
      near.back()->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      marks.insert(marks.end(), cells.size(), vtkDataSetAttributes::DUPLICATECELL);
    }
  }
  if (near.size() < 2)
  {
    return grid;
  }
  const Grid all = Appended(near);
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  array->SetNumberOfValues(all->GetNumberOfCells());
  std::ranges::copy(marks, array->GetPointer(0));
  Grid marked = Grid::Take(all->NewInstance());
  marked->ShallowCopy(all);
  marked->GetCellData()->AddArray(array);
  return marked;
}
} // namespace pixelexact
