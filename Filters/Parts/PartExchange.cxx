// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/PartExchange.h"

#include "Core/Base/Error.h"
#include "Grids/GridCopies.h"
#include "HighOrderArrays.h"
#include "PackedArrays.h"
#include "Parts/CommonWidths.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <iterator>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// Without point data, and without what is of no element.
Grid WithoutFields(vtkUnstructuredGrid* grid)
{
  Grid bare = IsPacked(grid) ? Unpack(grid) : Grid::New();
  if (!IsPacked(grid))
  {
    bare->ShallowCopy(grid);
    vtkNew<vtkFieldData> own;
    own->ShallowCopy(grid->GetFieldData());
    bare->SetFieldData(own);
  }
  bare->GetPointData()->Initialize();
  for (int i = bare->GetFieldData()->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const std::string name = bare->GetFieldData()->GetArrayName(i);
    if (name.starts_with(kFieldPrefix))
    {
      bare->GetFieldData()->RemoveArray(name.c_str());
    }
  }
  return bare;
}

Grid OfCommonWidths(vtkUnstructuredGrid* packed, vtkMultiProcessController* processes)
{
  const bool any = packed->GetNumberOfCells() > 0;
  const PackedWidths widths = CommonWidths(any ? WidthsFor(packed) : PackedWidths(), processes);
  return any ? Pack(packed, widths) : Grid(packed);
}

std::vector<Grid> ToGrids(const std::vector<vtkSmartPointer<vtkDataObject>>& received)
{
  std::vector<Grid> grids;
  for (const auto& object : received)
  {
    const Grid grid = vtkUnstructuredGrid::SafeDownCast(object);
    grids.push_back(grid ? grid : Grid::New());
  }
  return grids;
}
} // namespace

void AgreeThatAllIsWell(const std::string& problem, vtkMultiProcessController* processes)
{
  vtkMultiProcessStream own;
  own << problem;
  std::vector<vtkMultiProcessStream> all;
  processes->Gather(own, all, 0);
  std::string first;
  for (vtkMultiProcessStream& stream : all)
  {
    std::string text;
    stream >> text;
    first = first.empty() ? text : first;
  }
  vtkMultiProcessStream told;
  told << first;
  processes->Broadcast(told, 0);
  told >> first;
  if (!first.empty())
  {
    throw Error(first);
  }
}

Grid PackedCells(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& cells, bool fields)
{
  if (cells.empty())
  {
    return Grid::New();
  }
  // The cells first: only theirs are packed.
  return Pack(ExtractedCells(fields ? grid : WithoutFields(grid).Get(), cells));
}

std::vector<Grid> FromAll(vtkUnstructuredGrid* packed, vtkMultiProcessController* processes)
{
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  processes->AllGather(OfCommonWidths(packed, processes), received);
  return ToGrids(received);
}

std::vector<Grid> FromAllToFirst(vtkUnstructuredGrid* packed, vtkMultiProcessController* processes)
{
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  processes->Gather(OfCommonWidths(packed, processes), received, 0);
  return ToGrids(received);
}

Grid Appended(const std::vector<Grid>& packed)
{
  std::vector<Grid> filled;
  std::ranges::copy_if(packed, std::back_inserter(filled),
    [](const Grid& grid) { return grid && grid->GetNumberOfCells() > 0; });
  if (filled.size() < 2)
  {
    return filled.empty() ? Grid() : filled.front();
  }
  return AppendedGrids(filled);
}
} // namespace pixelexact
