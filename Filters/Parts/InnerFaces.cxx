// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/InnerFaces.h"

#include "Core/Base/Error.h"
#include "HighOrderModel.h"
#include "Parts/BareElements.h"
#include "Parts/PartExchange.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
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
} // namespace

Grid WithInnerFaces(vtkUnstructuredGrid* grid, vtkMultiProcessController* processes)
{
  const bool any = grid->GetNumberOfCells() > 0;
  std::shared_ptr<HighOrderModel> model;
  std::vector<unsigned char> inner;
  std::vector<vtkIdType> bare;
  Grid sent = Grid::New();
  std::string problem;
  try
  {
    if (any)
    {
      model = HighOrderModel::From(grid);
      inner = InnerOfAll(*model);
      bare = BareElements(*model, inner);
      sent = PackedCells(grid, bare, false);
    }
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  AgreeThatAllIsWell(problem, processes);
  std::vector<Grid> parts = FromAll(sent, processes);
  if (!any)
  {
    return grid;
  }
  // Its own come first, and those that are too far away are left out.
  const vtkBoundingBox here = BoxAround(*model);
  const auto own = static_cast<std::size_t>(processes->GetLocalProcessId());
  std::vector<Grid> near{ parts[own] };
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    if (p != own && parts[p]->GetNumberOfCells() > 0 &&
      here.Intersects(vtkBoundingBox(parts[p]->GetBounds())))
    {
      near.push_back(parts[p]);
    }
  }
  if (const Grid all = Appended(near); all && near.size() > 1)
  {
    const auto whole = HighOrderModel::From(all);
    for (std::size_t i = 0; i < bare.size(); ++i)
    {
      inner[static_cast<std::size_t>(bare[i])] |= InnerOf(*whole, static_cast<int>(i));
    }
  }
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(kInnerFaces);
  array->SetNumberOfValues(grid->GetNumberOfCells());
  std::ranges::copy(inner, array->GetPointer(0));
  Grid marked = Grid::Take(grid->NewInstance());
  marked->ShallowCopy(grid);
  marked->GetCellData()->AddArray(array);
  return marked;
}
} // namespace pixelexact
