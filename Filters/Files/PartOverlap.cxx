// SPDX-License-Identifier: BSD-3-Clause
#include "Files/PartOverlap.h"

#include "Conversion/ConvertedGrid.h"
#include "Conversion/SameCells.h"
#include "Core/Base/Counted.h"
#include "Files/GridFiles.h"
#include "Grids/GridCopies.h"
#include "HighOrderArrays.h"
#include "PackedArrays.h"
#include "Parts/PartExchange.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkMultiProcessController.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace pixelexact
{
namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

vtkDataArray* MarksOf(vtkUnstructuredGrid* grid)
{
  return grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
}

bool IsMarked(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkDataArray* marks = MarksOf(grid);
  return marks != nullptr &&
    (static_cast<int>(marks->GetComponent(cell, 0)) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

/// By part and cell: 1 where the cell is dropped.
using Dropped = std::vector<std::vector<char>>;

Dropped NoneDropped(const std::vector<ReadPart>& parts)
{
  Dropped dropped;
  for (const ReadPart& part : parts)
  {
    dropped.emplace_back(static_cast<std::size_t>(part.grid->GetNumberOfCells()), 0);
  }
  return dropped;
}

/// Drops cells from their parts, and clears the marks of duplicates of those that are kept.
void Drop(const Dropped& dropped, std::vector<ReadPart>& parts)
{
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    Grid& grid = parts[p].grid;
    std::vector<vtkIdType> kept;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      if (dropped[p][static_cast<std::size_t>(cell)] == 0)
      {
        kept.push_back(cell);
      }
    }
    if (static_cast<vtkIdType>(kept.size()) < grid->GetNumberOfCells())
    {
      grid = KeepCells(grid, kept);
    }
    vtkDataArray* marks = MarksOf(grid);
    for (vtkIdType cell = 0; marks != nullptr && cell < grid->GetNumberOfCells(); ++cell)
    {
      const int mark = static_cast<int>(marks->GetComponent(cell, 0));
      marks->SetComponent(cell, 0, mark & ~vtkDataSetAttributes::DUPLICATECELL);
    }
  }
  // Parts without cells go, unless all are without.
  const auto first = std::ranges::find_if(
    parts, [](const ReadPart& part) { return part.grid->GetNumberOfCells() > 0; });
  if (first != parts.end())
  {
    std::erase_if(parts, [](const ReadPart& part) { return part.grid->GetNumberOfCells() == 0; });
  }
}

/// Finds whether points are inside of cells of a grid.
class InsideGrid
{
public:
  explicit InsideGrid(vtkUnstructuredGrid* grid)
    : Searched(grid)
  {
    grid->GetBounds(Bounds.data());
  }

  /// `counts(number)` returns whether the cell with this number is included.
  template <class Counts>
  bool Has(const std::array<double, 3>& x, const Counts& counts)
  {
    for (std::size_t d = 0; d < 3; ++d)
    {
      if (!(x[d] >= Bounds[2 * d] && x[d] <= Bounds[2 * d + 1]))
      {
        return false;
      }
    }
    if (Locator->GetDataSet() == nullptr)
    {
      Locator->SetDataSet(Searched);
      Locator->BuildLocator();
    }
    double at[3] = { x[0], x[1], x[2] };
    double parametric[3];
    Weights.resize(
      std::max<std::size_t>(Weights.size(), static_cast<std::size_t>(Searched->GetMaxCellSize())));
    const vtkIdType cell = Locator->FindCell(at, 0.0, Cell, parametric, Weights.data());
    return cell >= 0 && counts(cell);
  }

private:
  vtkUnstructuredGrid* Searched;
  vtkSmartPointer<vtkStaticCellLocator> Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
  vtkSmartPointer<vtkGenericCell> Cell = vtkSmartPointer<vtkGenericCell>::New();
  std::array<double, 6> Bounds{};
  std::vector<double> Weights;
};

/// The image of a cell's parametric centre.
std::array<double, 3> CentreOf(vtkUnstructuredGrid* grid, vtkIdType index)
{
  vtkCell* cell = grid->GetCell(index);
  double parametric[3];
  std::array<double, 3> x{};
  int part = cell->GetParametricCenter(parametric);
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  cell->EvaluateLocation(part, parametric, x.data(), weights.data());
  return x;
}

std::vector<InsideGrid> InsideGrids(const std::vector<const ReadPart*>& parts)
{
  std::vector<InsideGrid> grids;
  grids.reserve(parts.size());
  for (const ReadPart* part : parts)
  {
    grids.emplace_back(part->grid);
  }
  return grids;
}

/// Whether at least half of the sampled centres of the parts' cells are inside cells of `grids`.
bool Covers(std::vector<InsideGrid>& grids, const std::vector<const ReadPart*>& parts)
{
  constexpr vtkIdType kSamples = 64; // of each part
  int inside = 0;
  int all = 0;
  for (const ReadPart* part : parts)
  {
    const vtkIdType cells = part->grid->GetNumberOfCells();
    const vtkIdType step = std::max<vtkIdType>(1, cells / kSamples);
    for (vtkIdType cell = 0; cell < cells; cell += step)
    {
      const auto x = CentreOf(part->grid, cell);
      const auto has = [&x](InsideGrid& grid)
      { return grid.Has(x, [](vtkIdType) { return true; }); };
      ++all;
      inside += std::ranges::any_of(grids, has) ? 1 : 0;
    }
  }
  return 2 * inside >= all;
}

std::string Quoted(const std::string& file)
{
  return "'" + file + "'";
}

/// Finds whether an unmarked cell of another part, of any kind and size, has the place of a cell.
class Covered
{
public:
  explicit Covered(const std::vector<ReadPart>& parts)
    : Parts(parts)
    , Grids(parts.size())
  {
  }

  bool Has(std::size_t part, vtkIdType cell)
  {
    const auto x = CentreOf(Parts[part].grid, cell);
    for (std::size_t p = 0; p < Parts.size(); ++p)
    {
      vtkUnstructuredGrid* grid = Parts[p].grid;
      if (p == part)
      {
        continue;
      }
      if (!Grids[p])
      {
        Grids[p] = std::make_unique<InsideGrid>(grid);
      }
      if (Grids[p]->Has(x, [grid](vtkIdType found) { return !IsMarked(grid, found); }))
      {
        return true;
      }
    }
    return false;
  }

private:
  const std::vector<ReadPart>& Parts;
  std::vector<std::unique_ptr<InsideGrid>> Grids;
};

struct Counts
{
  vtkIdType unowned = 0;
  vtkIdType repeated = 0;
};

void NoteCounts(const Counts& counts, std::vector<std::string>& notes)
{
  if (counts.unowned > 0)
  {
    notes.push_back(Counted(counts.unowned, "cell") +
      " marked as a duplicate by each part that holds it, and owned by none: kept once; a part may "
      "be missing.");
  }
  if (counts.repeated > 0)
  {
    notes.push_back(Counted(counts.repeated, "cell") +
      " held by several parts without a mark: each counts once, with the last part's values; mark "
      "all but one of them as duplicates (vtkGhostType).");
  }
}
/// The marked cells of the parts, in their order, without data.
Grid Bare(const std::vector<ReadPart>& parts, const std::vector<CellPlace>& marked)
{
  std::vector<Grid> grids;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    std::vector<vtkIdType> cells;
    for (const CellPlace& place : marked)
    {
      if (place.grid == p)
      {
        cells.push_back(place.cell);
      }
    }
    const auto structure = Grid::New();
    structure->CopyStructure(parts[p].grid);
    grids.push_back(cells.empty() ? structure : ExtractedCells(structure, cells));
    if (cells.empty())
    {
      grids.back()->Initialize();
    }
  }
  const Grid all = Appended(grids);
  return all ? all : Grid::New();
}

/// For each of this process's marked cells: 1 where no process has it unmarked, and it is the first
/// marked copy in the order of processes and cells.
std::vector<char> FindUnowned(const std::vector<ReadPart>& parts,
  const std::vector<CellPlace>& marked, vtkMultiProcessController& processes,
  std::vector<std::string>& notes)
{
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  processes.AllGather(Bare(parts, marked), received);
  std::vector<Grid> grids;
  grids.reserve(parts.size());
  for (const ReadPart& part : parts)
  {
    grids.push_back(part.grid);
  }
  std::vector<std::size_t> firstOf; // by process, among all marked cells
  std::size_t count = 0;
  for (const auto& object : received)
  {
    const Grid grid = vtkUnstructuredGrid::SafeDownCast(object);
    grids.push_back(grid ? grid : Grid::New());
    firstOf.push_back(count);
    count += static_cast<std::size_t>(grids.back()->GetNumberOfCells());
  }
  const auto isOwn = [&](const CellPlace& place) { return place.grid < parts.size(); };
  const auto indexOf = [&](const CellPlace& place)
  { return firstOf[place.grid - parts.size()] + static_cast<std::size_t>(place.cell); };
  const std::vector<vtkUnstructuredGrid*> all(grids.begin(), grids.end());
  std::vector<char> ownedHere(count, 0);
  std::vector<char> isFirst(count, 1);
  for (const auto& group : SameCells(all))
  {
    const bool owned = std::ranges::any_of(group,
      [&](const CellPlace& place)
      { return isOwn(place) && !IsMarked(all[place.grid], place.cell); });
    bool first = true;
    for (const CellPlace& place : group)
    {
      if (!isOwn(place))
      {
        ownedHere[indexOf(place)] = owned ? 1 : 0;
        isFirst[indexOf(place)] = first ? 1 : 0;
        first = false;
      }
    }
  }
  std::vector<char> owned(count, 0);
  if (count > 0)
  {
    processes.AllReduce(
      ownedHere.data(), owned.data(), static_cast<vtkIdType>(count), vtkCommunicator::MAX_OP);
  }
  Counts counts;
  std::vector<char> unowned(count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    unowned[i] = owned[i] == 0 && isFirst[i] != 0 ? 1 : 0;
    counts.unowned += unowned[i];
  }
  const auto process = static_cast<std::size_t>(processes.GetLocalProcessId());
  if (process == 0)
  {
    NoteCounts(counts, notes);
  }
  const auto begin = unowned.begin() + static_cast<std::ptrdiff_t>(firstOf[process]);
  return { begin, begin + static_cast<std::ptrdiff_t>(marked.size()) };
}

/// Whether the user named a part of a grid alone, whose marked cells are those of others; notes it.
bool KeepsMarks(const ReadPart& part, std::vector<std::string>& notes)
{
  vtkIdType marked = 0;
  for (vtkIdType cell = 0; cell < part.grid->GetNumberOfCells(); ++cell)
  {
    marked += IsMarked(part.grid, cell) ? 1 : 0;
  }
  const bool keeps = marked < part.grid->GetNumberOfCells();
  if (marked > 0 && keeps)
  {
    notes.push_back(Quoted(part.file.file) + ": " + Counted(marked, "cell") +
      " marked as duplicates of another part's (vtkGhostType) are not drawn; read all parts "
      "(.pvtu, "
      ".pvd).");
  }
  return keeps;
}
} // namespace

Grid KeepCells(vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells)
{
  // Packed, because FieldData would keep the coefficients of all.
  const bool carries = HasSolverCoefficients(grid);
  const Grid kept = ExtractedCells(carries ? Pack(grid).Get() : grid, cells);
  return carries && kept->GetNumberOfCells() > 0 ? Unpack(kept) : kept;
}

void DropReplacedParts(std::vector<ReadPart>& parts, std::vector<std::string>& notes)
{
  // Entries of a label, in the order of the collection.
  std::map<std::string, std::map<int, std::vector<const ReadPart*>>> byLabel;
  for (const ReadPart& part : parts)
  {
    if (!part.file.label.empty())
    {
      byLabel[part.file.label][part.file.entry].push_back(&part);
    }
  }
  std::set<int> replaced; // entries
  for (const auto& [label, entries] : byLabel)
  {
    for (auto earlier = entries.begin(); earlier != entries.end(); ++earlier)
    {
      auto grids = InsideGrids(earlier->second);
      const auto later = std::find_if(std::next(earlier), entries.end(),
        [&](const auto& entry)
        {
          if (!Covers(grids, entry.second))
          {
            return false;
          }
          auto others = InsideGrids(entry.second);
          return Covers(others, earlier->second);
        });
      if (later != entries.end())
      {
        replaced.insert(earlier->first);
        AddOnce(notes,
          Quoted(earlier->second.front()->file.list) + " lists the same part twice at this time: " +
            Quoted(later->second.front()->file.file) + " counts, which comes later, and " +
            Quoted(earlier->second.front()->file.file) + " does not.");
      }
    }
  }
  std::erase_if(parts,
    [&](const ReadPart& part)
    { return !part.file.label.empty() && replaced.contains(part.file.entry); });
}

void DropMarkedCells(std::vector<ReadPart>& parts, vtkMultiProcessController* processes,
  std::vector<std::string>& notes)
{
  Dropped dropped = NoneDropped(parts);
  std::vector<CellPlace> marked;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (vtkIdType cell = 0; cell < parts[p].grid->GetNumberOfCells(); ++cell)
    {
      if (IsMarked(parts[p].grid, cell))
      {
        dropped[p][static_cast<std::size_t>(cell)] = 1;
        marked.push_back({ p, cell });
      }
    }
  }
  if (processes != nullptr)
  {
    const std::vector<char> unowned = FindUnowned(parts, marked, *processes, notes);
    for (std::size_t i = 0; i < marked.size(); ++i)
    {
      dropped[marked[i].grid][static_cast<std::size_t>(marked[i].cell)] = unowned[i] != 0 ? 0 : 1;
    }
  }
  Drop(dropped, parts);
}

void DropSharedCells(std::vector<ReadPart>& parts, std::vector<std::string>& notes)
{
  if (parts.size() == 1 && parts[0].file.list.empty() && KeepsMarks(parts[0], notes))
  {
    return;
  }
  std::vector<vtkUnstructuredGrid*> grids;
  grids.reserve(parts.size());
  for (const ReadPart& part : parts)
  {
    grids.push_back(part.grid);
  }
  Dropped dropped = NoneDropped(parts);
  Dropped seen = dropped;
  const auto at = [](Dropped& cells, const CellPlace& place) -> char&
  { return cells[place.grid][static_cast<std::size_t>(place.cell)]; };
  const auto isMarked = [&](const CellPlace& place)
  { return IsMarked(grids[place.grid], place.cell); };
  Counts counts;
  Covered covered(parts);
  const auto keepUnowned = [&](const CellPlace& place)
  {
    at(seen, place) = 1;
    const bool isCovered = covered.Has(place.grid, place.cell);
    at(dropped, place) = isCovered ? 1 : 0;
    counts.unowned += isCovered ? 0 : 1;
  };
  const auto groups = parts.size() > 1 ? SameCells(grids) : std::vector<std::vector<CellPlace>>();
  for (const auto& group : groups)
  {
    const auto last = std::ranges::find_if_not(group.rbegin(), group.rend(), isMarked);
    if (last == group.rend())
    {
      keepUnowned(group.front());
      for (const CellPlace& place : std::span(group).subspan(1))
      {
        at(seen, place) = at(dropped, place) = 1;
      }
      continue;
    }
    bool repeated = false;
    for (const CellPlace& place : group)
    {
      // Cells that one part has twice are the file's own; the converter reports them.
      const bool isOthers = place.grid != last->grid;
      at(seen, place) = 1;
      at(dropped, place) = isMarked(place) || isOthers ? 1 : 0;
      repeated = repeated || (isOthers && !isMarked(place));
    }
    counts.repeated += repeated ? 1 : 0;
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (vtkIdType cell = 0; MarksOf(grids[p]) != nullptr && cell < grids[p]->GetNumberOfCells();
         ++cell)
    {
      const CellPlace place{ p, cell };
      if (isMarked(place) && at(seen, place) == 0)
      {
        keepUnowned(place);
      }
    }
  }
  Drop(dropped, parts);
  NoteCounts(counts, notes);
}
} // namespace pixelexact
