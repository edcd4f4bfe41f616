// SPDX-License-Identifier: BSD-3-Clause
#include "Files/GridParts.h"

#include "Cells/CellBasis.h"
#include "Conversion/OutputGrid.h"
#include "Core/Base/Error.h"
#include "Files/GridFiles.h"
#include "Files/PieceNumbers.h"
#include "Grids/ExtractedCells.h"
#include "HighOrderArrays.h"
#include "PackedArrays.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// The highest of its cells; 0: there is none.
int DimensionOf(vtkUnstructuredGrid* grid)
{
  // Cell by cell: what VTK has for the types that there are differs between its versions.
  int highest = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells() && highest < 3; ++cell)
  {
    const int dimension = CellDimension(grid->GetCellType(cell));
    // Unknown: the converter says what it is.
    highest = std::max(highest, dimension < 0 ? 3 : dimension);
  }
  return highest;
}

/// Takes out what only a grid of one part may have.
void StripPart(vtkUnstructuredGrid* grid)
{
  if (!HasSolverCoefficients(grid))
  {
    RemoveHighOrderArrays(grid);
  }
  vtkDataArray* ghosts = grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; ghosts && cell < grid->GetNumberOfCells(); ++cell)
  {
    if ((static_cast<int>(ghosts->GetComponent(cell, 0)) & vtkDataSetAttributes::DUPLICATECELL) !=
      0)
    {
      grid->RemoveGhostCells();
      return;
    }
  }
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
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOff();
  append->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  Names names;
  for (const auto& grid : grids)
  {
    append->AddInputData(grid);
    names.merge(ArrayNames(grid));
  }
  append->Update();
  const Names kept = ArrayNames(append->GetOutput());
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
  return append->GetOutput();
}
/// Parts that carry a solver's coefficients become packed ones, of the same widths, which can be
/// appended.
void PackParts(const std::vector<GridPart>& files, std::vector<Grid>& grids)
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
    throw Unsupported(CannotRead(files.front()) +
      "some of its parts carry a solver's own coefficients and others do not; write all parts with "
      "them, or one file per time step");
  }
  for (Grid& grid : grids)
  {
    grid = carrying != 0 ? Pack(grid, widths) : grid;
  }
}

/// Cells of one part, in their order.
Grid KeepCells(vtkUnstructuredGrid* grid, vtkIdType begin, vtkIdType end)
{
  std::vector<vtkIdType> cells(static_cast<std::size_t>(end - begin));
  std::iota(cells.begin(), cells.end(), begin);
  // Packed, because FieldData would keep the coefficients of all.
  const bool carries = HasSolverCoefficients(grid);
  const Grid kept = ExtractedCells(carries ? Pack(grid).Get() : grid, cells);
  return carries && kept->GetNumberOfCells() > 0 ? Unpack(kept) : kept;
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

/// One of several processes reads its share of a single file.
ReadGrid ReadShare(const GridPart& file, const PieceOf& share)
{
  ReadGrid result;
  std::string problem;
  try
  {
    GridFileReader reader(result.notes);
    const Grid whole = reader.Read(file);
    const auto [begin, end] = share.Of(whole->GetNumberOfCells());
    result.grid = KeepCells(whole, begin, end);
    if (!HasHighOrderArrays(result.grid) && end > begin)
    {
      NumberCells(result.grid, 0, end - begin, begin);
    }
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  (void)ElementsBefore({}, share, problem);
  return result;
}

struct ReadFile
{
  Grid grid;
  int dimension = 0;
  int number = 0; ///< among all files
};

/// Those of a share, without what only a grid of one part may have.
std::vector<ReadFile> ReadFiles(
  const std::vector<GridPart>& files, const PieceOf& share, std::vector<std::string>& notes)
{
  GridFileReader reader(notes);
  std::vector<ReadFile> read;
  const auto [begin, end] = share.Of(static_cast<std::int64_t>(files.size()));
  for (auto i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
  {
    const Grid grid = reader.Read(files[static_cast<std::size_t>(i)]);
    StripPart(grid);
    read.push_back({ grid, DimensionOf(grid), i });
  }
  return read;
}

/// The volumes among them, put together. `elements` gets their cells, by file.
Grid PutTogether(const std::vector<GridPart>& files, const std::vector<ReadFile>& read,
  PieceCounts& counts, std::vector<std::string>& notes)
{
  int dimension = 0;
  for (const ReadFile& file : read)
  {
    dimension = std::max(dimension, file.dimension);
  }
  if (dimension < 2)
  {
    throw Error(CannotRead(files.front()) + "it holds no volume and no plane mesh");
  }
  std::vector<Grid> volumes;
  for (const ReadFile& file : read)
  {
    if (file.dimension == dimension)
    {
      volumes.push_back(file.grid);
      counts.elements.emplace_back(file.number, file.grid->GetNumberOfCells());
    }
    else if (file.grid->GetNumberOfCells() > 0) // an idle process writes an empty file
    {
      notes.push_back("'" + files[static_cast<std::size_t>(file.number)].file +
        (dimension == 3 ? "' holds no volume and is left out."
                        : "' holds nothing of two dimensions and is left out."));
    }
  }
  PackParts(files, volumes);
  const Grid grid = volumes.size() == 1 ? volumes[0] : Append(volumes, notes);
  return IsPacked(grid) ? Unpack(grid) : grid;
}
} // namespace

ReadGrid ReadParts(const std::vector<GridPart>& parts, const PieceOf& share)
{
  ReadGrid result;
  const auto files = ListFiles(parts, result.notes);
  if (files.size() == 1)
  {
    if (!share.IsWhole())
    {
      return ReadShare(files[0], share);
    }
    GridFileReader reader(result.notes);
    result.grid = reader.Read(files[0]);
    return result;
  }
  PieceCounts counts{ static_cast<int>(files.size()), {} };
  std::string problem;
  try
  {
    const auto read = ReadFiles(files, share, result.notes);
    const bool idle = !share.IsWhole() &&
      std::ranges::all_of(
        read, [](const ReadFile& file) { return file.grid->GetNumberOfCells() == 0; });
    result.grid = idle ? Grid::New() : PutTogether(files, read, counts, result.notes);
  }
  catch (const std::exception& error)
  {
    if (share.IsWhole())
    {
      throw;
    }
    // Not yet: the other processes wait for this one.
    problem = error.what();
  }
  if (share.IsWhole())
  {
    return result;
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
