// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/PartExchange.h"

#include "Core/Base/Error.h"
#include "Grids/GridCopies.h"
#include "HighOrderArrays.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <iterator>
#include <numeric>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// A copy of the grid without point data and without fields.
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
  vtkMultiProcessStream stream;
  stream << first;
  processes->Broadcast(stream, 0);
  stream >> first;
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
  // Extracts the cells before packing, so that only these are packed.
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

PackedWidths CommonWidths(const PackedWidths& own, vtkMultiProcessController* controller)
{
  const bool several = controller != nullptr && controller->GetNumberOfProcesses() > 1;
  return several ? LargestOfAll(own, controller) : own;
}

vtkMultiProcessController* ProcessesOf(const PieceOf& part)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  return !part.IsWhole() && controller != nullptr &&
      controller->GetNumberOfProcesses() == part.count &&
      controller->GetLocalProcessId() == part.piece
    ? controller
    : nullptr;
}

PieceOf PieceAskedFor(vtkInformation* asked)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (asked == nullptr || asked->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) == 0 ||
    asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) < 2)
  {
    return {};
  }
  return { asked->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) };
}

std::vector<std::int64_t> ElementsBefore(
  const PieceCounts& counts, const PieceOf& part, const std::string& problem)
{
  auto* processes = ProcessesOf(part);
  int pieces = counts.pieces;
  if (processes != nullptr)
  {
    AgreeThatAllIsWell(problem, processes);
    // Processes without pieces do not know the number.
    processes->AllReduce(&counts.pieces, &pieces, 1, vtkCommunicator::MAX_OP);
  }
  else if (!problem.empty())
  {
    throw Error(problem);
  }
  std::vector<long long> elements(static_cast<std::size_t>(pieces), 0);
  for (const auto& [piece, count] : counts.elements)
  {
    elements[static_cast<std::size_t>(piece)] = count;
  }
  if (processes != nullptr && !elements.empty())
  {
    const std::vector<long long> own = elements;
    processes->AllReduce(own.data(), elements.data(), static_cast<vtkIdType>(elements.size()),
      vtkCommunicator::SUM_OP);
  }
  std::vector<std::int64_t> before;
  for (const auto& [piece, count] : counts.elements)
  {
    before.push_back(std::accumulate(elements.begin(), elements.begin() + piece, 0LL));
  }
  return before;
}
} // namespace pixelexact
