// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CgnsSides.h"

#include "Conversion/SourceArrays.h"
#include "Core/Base/Counted.h"
#include "Files/ExodusCells.h"
#include "Files/SolverGrid.h"

#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <unordered_set>

namespace pixelexact
{
namespace
{
using Face = CgnsBoundary::Face;

/// A side of a cell by its corners, sorted.
struct Side
{
  Face corners{ -1, -1, -1, -1 };
  ElementFace face;

  auto operator<=>(const Side&) const = default;
};

/// The sides of cells, sorted by their corners; two cells may share one.
std::vector<Side> SidesIn(vtkUnstructuredGrid& grid)
{
  std::vector<Side> sides;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    grid.GetCellPoints(cell, points);
    for (const CellSide& side : SidesOf(grid.GetCellType(cell)))
    {
      Side& own = sides.emplace_back();
      for (int k = 0; k < side.count; ++k)
      {
        own.corners[static_cast<std::size_t>(k)] =
          points->GetId(side.corners[static_cast<std::size_t>(k)]);
      }
      std::ranges::sort(own.corners);
      own.face = { static_cast<std::int32_t>(cell), side.face };
    }
  }
  std::ranges::sort(sides);
  return sides;
}

/// Sides that belong to one cell only, sorted by their last corner, so that those of a zone are
/// consecutive.
std::vector<Side> OuterOf(const std::vector<Side>& sides)
{
  std::vector<Side> outer;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const bool shared = (i > 0 && sides[i - 1].corners == sides[i].corners) ||
      (i + 1 < sides.size() && sides[i + 1].corners == sides[i].corners);
    if (!shared)
    {
      outer.push_back(sides[i]);
    }
  }
  std::ranges::sort(outer, {}, [](const Side& side) { return side.corners.back(); });
  return outer;
}

/// The first point of each zone in the grid; empty where the blocks do not match the zones.
std::vector<std::int64_t> BeginningsOf(
  const std::vector<CgnsZone>& zones, vtkMultiBlockDataSet& read)
{
  std::vector<std::int64_t> begin;
  std::int64_t points = 0;
  const auto leaves = vtk::TakeSmartPointer(read.NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    const std::size_t zone = begin.size();
    if (leaf == nullptr || zone == zones.size() || leaf->GetNumberOfPoints() != zones[zone].points)
    {
      return {};
    }
    begin.push_back(points);
    points += leaf->GetNumberOfCells() > 0 ? leaf->GetNumberOfPoints() : 0;
  }
  return begin.size() == zones.size() ? begin : std::vector<std::int64_t>();
}

class FaceFinder
{
public:
  explicit FaceFinder(vtkUnstructuredGrid& grid)
    : Sides(SidesIn(grid))
    , Outer(OuterOf(Sides))
  {
  }

  /// Adds the sides of a condition on a zone whose points start at `begin`. Returns the number that
  /// are not sides of cells.
  std::size_t Add(const CgnsBoundary& boundary, std::int64_t begin, std::int32_t attribute)
  {
    std::size_t others = 0;
    for (Face face : boundary.faces)
    {
      std::ranges::for_each(face, [begin](std::int64_t& point) { point += point < 0 ? 0 : begin; });
      std::ranges::sort(face);
      auto side = std::ranges::lower_bound(Sides, face, {}, &Side::corners);
      others += side == Sides.end() || side->corners != face ? 1 : 0;
      for (; side != Sides.end() && side->corners == face; ++side)
      {
        Found.push_back({ side->face, attribute });
      }
    }
    return others + (boundary.points.empty() ? 0 : AddByPoints(boundary, begin, attribute));
  }

  std::vector<AttributedFace> Found;

private:
  /// Outer sides that have all their corners among the points.
  std::size_t AddByPoints(const CgnsBoundary& boundary, std::int64_t begin, std::int32_t attribute)
  {
    std::unordered_set<std::int64_t> points;
    for (const std::int64_t point : boundary.points)
    {
      points.insert(begin + point);
    }
    const auto last = [](const Side& side) { return side.corners.back(); };
    const std::int64_t end = begin + *std::ranges::max_element(boundary.points);
    const std::size_t before = Found.size();
    for (auto side = std::ranges::lower_bound(Outer, begin, {}, last);
         side != Outer.end() && last(*side) <= end; ++side)
    {
      if (std::ranges::all_of(
            side->corners, [&](std::int64_t point) { return point < 0 || points.contains(point); }))
      {
        Found.push_back({ side->face, attribute });
      }
    }
    return Found.size() == before ? 1 : 0;
  }

  std::vector<Side> Sides;
  std::vector<Side> Outer;
};
} // namespace

void AddBoundaryConditions(const std::vector<CgnsZone>& zones, vtkMultiBlockDataSet& read,
  vtkUnstructuredGrid& grid, std::vector<std::string>& notes)
{
  if (std::ranges::all_of(
        zones, [](const CgnsZone& zone) { return zone.boundaries.empty() && zone.left.empty(); }))
  {
    return;
  }
  const std::vector<std::int64_t> begin = BeginningsOf(zones, read);
  if (begin.empty())
  {
    notes.emplace_back(
      "boundary conditions were left out: VTK's reader gives other points than the "
      "file's zones have.");
    return;
  }
  FaceFinder finder(grid);
  std::vector<Group> named;
  std::size_t others = 0;
  std::vector<std::string> left;
  for (std::size_t zone = 0; zone < zones.size(); ++zone)
  {
    left.insert(left.end(), zones[zone].left.begin(), zones[zone].left.end());
    for (const CgnsBoundary& boundary : zones[zone].boundaries)
    {
      auto group = std::ranges::find(named, boundary.name, &Group::name);
      if (group == named.end())
      {
        named.push_back({ static_cast<std::int32_t>(named.size()) + 1, boundary.name, true });
        group = std::prev(named.end());
      }
      others += finder.Add(boundary, begin[zone], group->id);
    }
  }
  std::ranges::sort(finder.Found);
  AddSourceFaces(finder.Found, &grid);
  AddGroupNames(named, &grid);
  if (others > 0)
  {
    notes.push_back(Counted(others, "face") +
      " of boundary conditions are no sides of elements and were left out.");
  }
  if (!left.empty())
  {
    notes.push_back("boundary conditions that contradict their zone, or of forms that are not "
                    "read, were left out: " +
      Counted(left.size(), "condition") + ", the first of them '" + left.front() + "'.");
  }
}
} // namespace pixelexact
