// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/SameCells.h"

#include "Cells/CellBasis.h"
#include "Core/Element/ElementUnits.h"
#include "Core/Math/Vec.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace pixelexact
{
namespace
{
/// Width of a bin in tolerances: narrower ones put more cells into several bins, wider ones put
/// more cells into each.
constexpr double kBinWidth = 8.0;

/// Corners of a type of cell, which come first among its points; 0: it is none of two or three
/// dimensions.
vtkIdType CornersOf(int type)
{
  const int dimension = CellDimension(type);
  if (dimension < 2)
  {
    return 0;
  }
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  // Euler's formula.
  return dimension == 2 ? cell->GetNumberOfEdges()
                        : cell->GetNumberOfEdges() - cell->GetNumberOfFaces() + 2;
}

/// Corners of one cell.
struct CellCorners
{
  Vec3 low{ INFINITY };
  Vec3 high{ -INFINITY };
  Vec3 mean{ 0.0 };
};

class Finder
{
public:
  explicit Finder(std::span<vtkUnstructuredGrid* const> grids)
    : Grids(grids)
  {
    double largest = 0.0;
    double roundoff = std::numeric_limits<double>::epsilon() / 2;
    for (vtkUnstructuredGrid* grid : grids)
    {
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        const int type = grid->GetCellType(cell);
        const auto [known, isNew] = CornersOfType.try_emplace(type, 0);
        if (isNew)
        {
          known->second = CornersOf(type);
        }
      }
      if (grid->GetNumberOfPoints() > 0)
      {
        double bounds[6];
        grid->GetPoints()->GetBounds(bounds);
        for (const double bound : bounds)
        {
          largest = std::fmax(largest, std::fabs(bound));
        }
        if (grid->GetPoints()->GetDataType() == VTK_FLOAT)
        {
          roundoff = kFloatRoundoff;
        }
      }
    }
    Tolerance = kCoordinateRoundings * roundoff * largest;
  }

  std::vector<std::vector<CellPlace>> Find()
  {
    for (std::size_t g = 0; g < Grids.size(); ++g)
    {
      AddEntries(g);
    }
    tbb::parallel_sort(Entries.begin(), Entries.end());
    for (auto begin = Entries.begin(); begin != Entries.end();)
    {
      const auto end =
        std::find_if(begin, Entries.end(), [&](const Entry& e) { return e.key != begin->key; });
      ComparePairs(begin, end);
      begin = end;
    }
    return Groups();
  }

private:
  struct Entry
  {
    std::uint64_t key = 0; ///< of a bin
    CellPlace place;
    Vec3 centre; ///< of the corners' box

    bool operator<(const Entry& other) const
    {
      return std::pair(key, place) < std::pair(other.key, other.place);
    }
  };
  using Iterator = tbb::concurrent_vector<Entry>::iterator;

  [[nodiscard]] bool ReadCorners(const CellPlace& place, vtkIdList& ids, CellCorners& corners) const
  {
    vtkUnstructuredGrid* grid = Grids[place.grid];
    const vtkIdType wanted = CornersOfType.at(grid->GetCellType(place.cell));
    grid->GetCellPoints(place.cell, &ids);
    if (wanted == 0 || ids.GetNumberOfIds() < wanted)
    {
      return false;
    }
    for (vtkIdType i = 0; i < wanted; ++i)
    {
      double x[3];
      grid->GetPoints()->GetPoint(ids.GetId(i), x);
      const Vec3 point(x[0], x[1], x[2]);
      corners.low = glm::min(corners.low, point);
      corners.high = glm::max(corners.high, point);
      corners.mean += point / static_cast<double>(wanted);
    }
    return std::isfinite(corners.mean.x + corners.mean.y + corners.mean.z);
  }

  /// A cell is in the bin of its box's centre, and in those that are nearer than the tolerance.
  void AddEntries(std::size_t grid)
  {
    tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, Grids[grid]->GetNumberOfCells(), 1024),
      [&](const tbb::blocked_range<vtkIdType>& cells)
      {
        const vtkNew<vtkIdList> ids;
        for (vtkIdType cell = cells.begin(); cell < cells.end(); ++cell)
        {
          CellCorners corners;
          const CellPlace place{ grid, cell };
          if (ReadCorners(place, *ids, corners))
          {
            AddBins(place, (corners.low + corners.high) / 2.0);
          }
        }
      });
  }

  void AddBins(const CellPlace& place, const Vec3& centre)
  {
    const double width = std::max(kBinWidth * Tolerance, std::numeric_limits<double>::min());
    std::array<std::array<std::int64_t, 2>, 3> bins{};
    for (int d = 0; d < 3; ++d)
    {
      bins[d] = { static_cast<std::int64_t>(std::floor((centre[d] - Tolerance) / width)),
        static_cast<std::int64_t>(std::floor((centre[d] + Tolerance) / width)) };
    }
    for (int i = 0; i < 8; ++i)
    {
      std::uint64_t key = 0;
      bool isNew = true;
      for (int d = 0; d < 3; ++d)
      {
        const std::size_t side = (i >> d) & 1;
        isNew = isNew && (side == 0 || bins[d][0] != bins[d][1]);
        // Multipliers of Knuth's hash; cells of other bins with this key are compared in vain.
        key = (key ^ static_cast<std::uint64_t>(bins[d][side])) * 0x9e3779b97f4a7c15U;
        key ^= key >> 29U;
      }
      if (isNew)
      {
        Entries.push_back({ key, place, centre });
      }
    }
  }

  [[nodiscard]] bool AreNear(const Vec3& a, const Vec3& b) const
  {
    const Vec3 d = glm::abs(a - b);
    return d.x <= Tolerance && d.y <= Tolerance && d.z <= Tolerance;
  }

  [[nodiscard]] bool AreSame(const CellPlace& a, const CellPlace& b) const
  {
    const vtkNew<vtkIdList> ids;
    CellCorners first;
    CellCorners second;
    vtkUnstructuredGrid* grid = Grids[a.grid];
    vtkUnstructuredGrid* other = Grids[b.grid];
    if (grid->GetCellType(a.cell) != other->GetCellType(b.cell) ||
      grid->GetCells()->GetCellSize(a.cell) != other->GetCells()->GetCellSize(b.cell) ||
      !ReadCorners(a, *ids, first) || !ReadCorners(b, *ids, second))
    {
      return false;
    }
    return AreNear(first.low, second.low) && AreNear(first.high, second.high) &&
      AreNear(first.mean, second.mean);
  }

  /// Entries of one bin.
  void ComparePairs(const Iterator& begin, const Iterator& end)
  {
    for (auto a = begin; a != end; ++a)
    {
      for (auto b = a + 1; b != end; ++b)
      {
        if (AreNear(a->centre, b->centre) && a->place != b->place && AreSame(a->place, b->place))
        {
          Pairs.emplace_back(a->place, b->place);
          break; // the next one is compared with those after it
        }
      }
    }
  }

  /// Pairs that share a cell are one group.
  std::vector<std::vector<CellPlace>> Groups()
  {
    std::ranges::sort(Pairs);
    std::map<CellPlace, std::size_t> groupOf;
    std::vector<std::vector<CellPlace>> groups;
    for (const auto& [a, b] : Pairs)
    {
      const auto [group, isNew] = groupOf.try_emplace(a, groups.size());
      if (isNew)
      {
        groups.push_back({ a });
      }
      if (groupOf.try_emplace(b, group->second).second)
      {
        groups[group->second].push_back(b);
      }
    }
    return groups;
  }

  std::span<vtkUnstructuredGrid* const> Grids;
  std::map<int, vtkIdType> CornersOfType;
  double Tolerance = 0.0;
  tbb::concurrent_vector<Entry> Entries;
  std::vector<std::pair<CellPlace, CellPlace>> Pairs; ///< the earlier one first
};
} // namespace

std::vector<std::vector<CellPlace>> SameCells(std::span<vtkUnstructuredGrid* const> grids)
{
  return Finder(grids).Find();
}
} // namespace pixelexact
