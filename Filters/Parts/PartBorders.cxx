// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/PartBorders.h"

#include "Core/Base/Error.h"
#include "Core/Faces/FaceTable.h"
#include "Core/Location/Locator.h"
#include "Core/Shape/ShapeFace.h"
#include "Grids/GridCopies.h"
#include "HighOrderModel.h"
#include "PackedArrays.h"
#include "Parts/PartExchange.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <exception>
#include <vector>

namespace pixelexact
{
namespace
{
int FacesOfElement(const HighOrderModel& model, int element)
{
  return static_cast<int>(FacesOf(model.GetMesh().ShapeOf(element)).size());
}

/// The faces of an element that have a neighbour, as bits.
unsigned char InnerOf(const HighOrderModel& model, int element)
{
  unsigned int bits = 0;
  for (int face = 0; face < FacesOfElement(model, element); ++face)
  {
    const FaceKind kind = model.Faces().KindOf(element, face);
    bits |= kind == FaceKind::Interior || kind == FaceKind::Hanging
      ? 1U << static_cast<unsigned int>(face)
      : 0U;
  }
  return static_cast<unsigned char>(bits);
}

/// The same of all elements.
std::vector<unsigned char> InnerOfAll(const HighOrderModel& model)
{
  std::vector<unsigned char> inner;
  inner.reserve(static_cast<std::size_t>(model.GetMesh().Elements()));
  for (int e = 0; e < model.GetMesh().Elements(); ++e)
  {
    inner.push_back(InnerOf(model, e));
  }
  return inner;
}

/// The elements with other faces, in their order. `inner`: InnerOfAll.
std::vector<vtkIdType> BareElements(
  const HighOrderModel& model, const std::vector<unsigned char>& inner)
{
  std::vector<vtkIdType> bare;
  for (std::size_t e = 0; e < inner.size(); ++e)
  {
    const int faces = FacesOfElement(model, static_cast<int>(e));
    if (inner[e] + 1U != 1U << static_cast<unsigned int>(faces))
    {
      bare.push_back(static_cast<vtkIdType>(e));
    }
  }
  return bare;
}

/// The box of the elements, with some room.
vtkBoundingBox BoxAround(const HighOrderModel& model)
{
  const Box3& box = model.GetLocator().Bounds();
  vtkBoundingBox bounds(
    box.lower.x, box.upper.x, box.lower.y, box.upper.y, box.lower.z, box.upper.z);
  bounds.Inflate(1e-6 * bounds.GetDiagonalLength());
  return bounds;
}

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// The cells for which three times the box of their points intersects the box.
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
