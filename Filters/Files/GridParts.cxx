// SPDX-License-Identifier: BSD-3-Clause
#include "Files/GridParts.h"

#include "Cells/CellBasis.h"
#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Error.h"
#include "Files/GridFiles.h"
#include "Files/PartOverlap.h"
#include "Grids/GridCopies.h"
#include "HighOrderArrays.h"
#include "PackedArrays.h"
#include "Parts/PartExchange.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// The highest dimension of its cells, up to `limit`; 0: there is none.
int DimensionOf(vtkUnstructuredGrid* grid, int limit)
{
  // Cell by cell: what VTK has for the types that there are differs between its versions.
  int highest = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells() && highest < limit; ++cell)
  {
    const int dimension = CellDimension(grid->GetCellType(cell));
    // The converter reports unknown types.
    const int counted = dimension < 0 ? 3 : dimension;
    highest = counted <= limit ? std::max(highest, counted) : highest;
  }
  return highest;
}

using Names = std::set<std::pair<std::string, std::string>>; // kind, name
Names ArrayNames(vtkUnstructuredGrid* grid)
{
  Names names;
  const auto add = [&names](const char* kind, vtkDataSetAttributes* data)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      names.emplace(kind, data->GetArrayName(i) ? data->GetArrayName(i) : "");
    }
  };
  add("point", grid->GetPointData());
  add("cell", grid->GetCellData());
  return names;
}

Grid Append(const std::vector<Grid>& grids, std::vector<std::string>& notes)
{
  FillCellKinds(grids);
  Names names;
  for (const auto& grid : grids)
  {
    names.merge(ArrayNames(grid));
  }
  Grid all = AppendedGrids(grids);
  if (std::ranges::any_of(grids,
        [&](const Grid& grid)
        { return grid->GetPoints()->GetDataType() != all->GetPoints()->GetDataType(); }))
  {
    notes.emplace_back("some parts have coordinates in single precision; the rounding of these is "
                       "not counted as an error of the mesh.");
  }
  names.erase({ "cell", vtkDataSetAttributes::GhostArrayName() }); // its work is done
  const Names kept = ArrayNames(all);
  for (const auto& [kind, name] : names)
  {
    if (!kept.contains({ kind, name }))
    {
      notes.emplace_back("the ")
        .append(kind)
        .append(" array '")
        .append(name)
        .append("' is not in all parts alike and is left out.");
    }
  }
  return all;
}

/// Parts that carry a solver's coefficients become packed ones, of the same widths, which can be
/// appended.
void PackParts(const std::vector<ReadPart>& parts, std::vector<Grid>& grids)
{
  PackedWidths widths;
  std::size_t carrying = 0;
  for (const Grid& grid : grids)
  {
    if (HasSolverCoefficients(grid))
    {
      ++carrying;
      Widen(widths, WidthsFor(grid));
    }
  }
  if (carrying != 0 && carrying != grids.size())
  {
    throw Unsupported(CannotRead(parts.front().file) +
      "some of its parts carry a solver's own coefficients and others do not; write all parts with "
      "them, or one file per time step");
  }
  for (Grid& grid : grids)
  {
    grid = carrying != 0 ? Pack(grid, widths) : grid;
  }
}

/// Cells from `begin` on get the numbers from `first` on.
void NumberCells(vtkUnstructuredGrid* grid, vtkIdType begin, vtkIdType end, std::int64_t first)
{
  vtkSmartPointer<vtkTypeInt64Array> numbers =
    vtkTypeInt64Array::SafeDownCast(grid->GetCellData()->GetArray(kSourceCells));
  if (!numbers)
  {
    numbers = vtkSmartPointer<vtkTypeInt64Array>::New();
    numbers->SetName(kSourceCells);
    numbers->SetNumberOfValues(grid->GetNumberOfCells());
    grid->GetCellData()->AddArray(numbers);
  }
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    numbers->SetValue(cell, first + cell - begin);
  }
}

/// The pieces of files from `begin` to `end` on, without what only a grid of one part may have.
std::vector<ReadPart> ReadFiles(const std::vector<GridPart>& files, std::int64_t begin,
  std::int64_t end, std::vector<std::string>& notes)
{
  GridFileReader reader(notes);
  std::vector<ReadPart> read;
  for (auto i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
  {
    const GridPart& file = files[static_cast<std::size_t>(i)];
    for (const Grid& grid : reader.Read(file))
    {
      if (files.size() > 1 && !HasSolverCoefficients(grid))
      {
        RemoveHighOrderArrays(grid);
      }
      read.push_back({ grid, file, i });
    }
  }
  return read;
}

/// Keeps the volumes among parts, or where there is none, or with `surfaces`, the parts with
/// surface elements.
void KeepHighestDimension(
  std::vector<ReadPart>& parts, bool surfaces, std::vector<std::string>& notes)
{
  std::vector<int> dimensions(parts.size());
  std::ranges::transform(parts, dimensions.begin(),
    [surfaces](const ReadPart& part) { return DimensionOf(part.grid, surfaces ? 2 : 3); });
  const int highest = *std::ranges::max_element(dimensions);
  if (highest < 2 && parts.size() > 1)
  {
    throw Error(CannotRead(parts.front().file) +
      (surfaces ? "it holds no surface elements; leave out --surface-elements"
                : "it holds no volume and no plane mesh"));
  }
  std::vector<ReadPart> kept;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (dimensions[i] == highest)
    {
      kept.push_back(parts[i]);
    }
    else if (parts[i].grid->GetNumberOfCells() > 0) // an idle process writes an empty file
    {
      const bool isPiece = std::ranges::count(parts, parts[i].number, &ReadPart::number) > 1;
      AddOnce(notes,
        std::string(isPiece ? "a piece of '" : "'") + parts[i].file.file +
          (highest < 3             ? "' holds nothing of two dimensions and is left out."
              : dimensions[i] == 2 ? "' holds no volume and is left out; --surface-elements reads "
                                     "the surfaces in place of the volumes."
                                   : "' holds no volume and is left out."));
    }
  }
  parts = std::move(kept);
}

/// Joins parts without common cells. `counts` gets their cells, by file.
Grid PutTogether(
  const std::vector<ReadPart>& parts, PieceCounts& counts, std::vector<std::string>& notes)
{
  std::vector<Grid> grids;
  for (const ReadPart& part : parts)
  {
    grids.push_back(part.grid);
    auto& counted = counts.elements;
    if (counted.empty() || counted.back().first != part.number)
    {
      counted.emplace_back(part.number, 0);
    }
    counted.back().second += part.grid->GetNumberOfCells();
  }
  if (grids.size() == 1)
  {
    return grids[0];
  }
  PackParts(parts, grids);
  const Grid grid = Append(grids, notes);
  if (parts.front().number == parts.back().number)
  {
    grid->GetFieldData()->ShallowCopy(grids.front()->GetFieldData()); // each piece has the file's
  }
  return IsPacked(grid) ? Unpack(grid) : grid;
}

Grid ReadWhole(const std::vector<GridPart>& files, bool surfaces, std::vector<std::string>& notes)
{
  auto parts = ReadFiles(files, 0, static_cast<std::int64_t>(files.size()), notes);
  KeepHighestDimension(parts, surfaces, notes);
  DropReplacedParts(parts, notes);
  DropSharedCells(parts, notes);
  PieceCounts counts;
  return PutTogether(parts, counts, notes);
}

/// Several processes do not compare their parts.
void NoteRepeatedLabels(const std::vector<GridPart>& files, std::vector<std::string>& notes)
{
  std::map<std::string, int> entryOf;
  for (const GridPart& file : files)
  {
    const auto known = entryOf.try_emplace(file.label, file.entry).first;
    if (!file.label.empty() && known->second != file.entry)
    {
      AddOnce(notes,
        "'" + file.list +
          "' lists a part of the same group, part and name twice at this time: where both overlap, "
          "several processes count both; list the one that is meant, or use one process.");
    }
  }
}

/// The numbers of the cells that become elements: all of a grid with coefficients, else those of
/// the highest dimension, or with `surfaces` of two dimensions.
std::vector<vtkIdType> ElementCellsOf(vtkUnstructuredGrid* grid, bool surfaces)
{
  std::vector<vtkIdType> cells;
  const bool areAll = HasHighOrderArrays(grid);
  const int wanted = areAll ? 0 : DimensionOf(grid, surfaces ? 2 : 3);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int dimension = areAll ? 0 : CellDimension(grid->GetCellType(cell));
    if ((dimension < 0 ? 3 : dimension) == wanted)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

/// Reads the share of one of several processes in a single file.
ReadGrid ReadShare(const GridPart& file, const PieceOf& share, bool surfaces)
{
  ReadGrid result;
  std::string problem;
  try
  {
    const Grid whole = ReadWhole({ file }, surfaces, result.notes);
    const std::vector<vtkIdType> all = ElementCellsOf(whole, surfaces);
    const auto [begin, end] = share.Of(std::ssize(all));
    const std::vector<vtkIdType> cells(all.begin() + begin, all.begin() + end);
    result.grid = KeepCells(whole, cells);
    const bool areNumbered = HasHighOrderArrays(result.grid);
    for (vtkIdType own = 0; !areNumbered && own < std::ssize(cells); ++own)
    {
      NumberCells(result.grid, own, own + 1, cells[static_cast<std::size_t>(own)]);
    }
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  (void)ElementsBefore({}, share, problem);
  return result;
}
} // namespace

ReadGrid ReadParts(const std::vector<GridPart>& parts, const PieceOf& share, bool surfaces)
{
  ReadGrid result;
  const auto files = ListFiles(parts, result.notes);
  if (share.IsWhole())
  {
    result.grid = ReadWhole(files, surfaces, result.notes);
    return result;
  }
  if (files.size() == 1)
  {
    return ReadShare(files[0], share, surfaces);
  }
  NoteRepeatedLabels(files, result.notes);
  PieceCounts counts{ static_cast<int>(files.size()), {} };
  auto* processes = ProcessesOf(share);
  std::vector<ReadPart> read;
  std::string problem;
  // An error is thrown after all processes have received it.
  const auto attempt = [&problem](const auto& work)
  {
    try
    {
      work();
    }
    catch (const std::exception& error)
    {
      problem = error.what();
    }
  };
  attempt(
    [&]
    {
      const auto [begin, end] = share.Of(static_cast<std::int64_t>(files.size()));
      read = ReadFiles(files, begin, end, result.notes);
      std::erase_if(read,
        [surfaces](const ReadPart& part) { return surfaces && DimensionOf(part.grid, 2) < 2; });
      const bool idle = std::ranges::all_of(
        read, [](const ReadPart& part) { return part.grid->GetNumberOfCells() == 0; });
      if (idle)
      {
        read.clear();
      }
      else
      {
        KeepHighestDimension(read, surfaces, result.notes);
      }
    });
  if (processes != nullptr)
  {
    AgreeThatAllIsWell(problem, processes);
  }
  if (problem.empty())
  {
    attempt(
      [&]
      {
        DropMarkedCells(read, processes, result.notes);
        result.grid = read.empty() ? Grid::New() : PutTogether(read, counts, result.notes);
      });
  }
  const auto before = ElementsBefore(counts, share, problem);
  vtkIdType begin = 0;
  for (std::size_t i = 0; i < before.size() && !HasHighOrderArrays(result.grid); ++i)
  {
    const auto end = begin + static_cast<vtkIdType>(counts.elements[i].second);
    NumberCells(result.grid, begin, end, before[i]);
    begin = end;
  }
  return result;
}
} // namespace pixelexact
