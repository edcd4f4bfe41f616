// SPDX-License-Identifier: BSD-3-Clause
#include "Input/CgnsSides.h"

#include "Core/Base/Counted.h"
#include "Input/CellSides.h"
#include "SolverGroups.h"
#include "SourceFaces.h"

#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace pixelexact
{
namespace
{
using Face = CgnsBoundary::Face;

struct FaceHash
{
  std::size_t operator()(const Face& face) const
  {
    std::size_t hash = 0;
    for (const std::int64_t point : face)
    {
      hash = hash * 1000003U + static_cast<std::size_t>(point);
    }
    return hash;
  }
};

/// Sides of cells by their corners, sorted. Two cells may share one.
using SideMap = std::unordered_multimap<Face, ElementFace, FaceHash>;

SideMap SidesIn(vtkUnstructuredGrid& grid)
{
  SideMap sides;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
  {
    grid.GetCellPoints(cell, points);
    for (const CellSide& side : SidesOf(grid.GetCellType(cell)))
    {
      Face corners{ -1, -1, -1, -1 };
      for (int k = 0; k < side.count; ++k)
      {
        corners[static_cast<std::size_t>(k)] =
          points->GetId(side.corners[static_cast<std::size_t>(k)]);
      }
      std::ranges::sort(corners);
      sides.emplace(corners, ElementFace{ static_cast<std::int32_t>(cell), side.face });
    }
  }
  return sides;
}

/// Where each zone's points begin in the grid; none where the blocks are not the zones.
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
  {
  }

  /// Adds those of a condition; says how many of them are no sides of cells.
  std::size_t Add(const CgnsBoundary& boundary, std::int64_t begin, std::int32_t attribute)
  {
    std::size_t others = 0;
    for (Face face : boundary.faces)
    {
      std::ranges::for_each(face, [begin](std::int64_t& point) { point += point < 0 ? 0 : begin; });
      std::ranges::sort(face);
      const auto [first, last] = Sides.equal_range(face);
      others += first == last ? 1 : 0;
      std::for_each(first, last,
        [&](const auto& side) {
          Found.push_back({ side.second, attribute });
        });
    }
    return others + (boundary.points.empty() ? 0 : AddByPoints(boundary, begin, attribute));
  }

  std::vector<AttributedFace> Found;

private:
  /// Sides of one cell alone that have all their corners among the points.
  std::size_t AddByPoints(const CgnsBoundary& boundary, std::int64_t begin, std::int32_t attribute)
  {
    std::unordered_set<std::int64_t> points;
    for (const std::int64_t point : boundary.points)
    {
      points.insert(begin + point);
    }
    const std::size_t before = Found.size();
    for (const auto& [corners, side] : Sides)
    {
      if (std::ranges::all_of(
            corners, [&](std::int64_t point) { return point < 0 || points.contains(point); }) &&
        Sides.count(corners) == 1)
      {
        Found.push_back({ side, attribute });
      }
    }
    return Found.size() == before ? 1 : 0;
  }

  SideMap Sides;
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
  SolverMesh named;
  std::size_t others = 0;
  std::vector<std::string> left;
  for (std::size_t zone = 0; zone < zones.size(); ++zone)
  {
    left.insert(left.end(), zones[zone].left.begin(), zones[zone].left.end());
    for (const CgnsBoundary& boundary : zones[zone].boundaries)
    {
      auto group = std::ranges::find(named.groups, boundary.name, &Group::name);
      if (group == named.groups.end())
      {
        named.groups.push_back(
          { static_cast<std::int32_t>(named.groups.size()) + 1, boundary.name, true });
        group = std::prev(named.groups.end());
      }
      others += finder.Add(boundary, begin[zone], group->id);
    }
  }
  std::ranges::sort(finder.Found);
  AddSourceFaces(finder.Found, &grid);
  AddGroups(named, &grid);
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
