// SPDX-License-Identifier: BSD-3-Clause
// Compares nodes with the edges and faces that they fit. An entity is an edge, a face or the inside
// of a cell. The mean of its nodes is compared with the means of the corners of all entities that
// have as many nodes. In a sound cell, curved or not, the nearest one is its own.
#include "Conversion/MeshDiagnostics.h"

#include "Conversion/SameCells.h"
#include "Core/Base/Counted.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace pixelexact
{
namespace
{
/// A node is assigned to another place where it is nearer to it by this factor, in the mean.
constexpr double kMuchNearer = 3.0;
/// The number of cells that are examined, evenly spread over the mesh.
constexpr int kMaxExamined = 20000;
/// Share of the cells of a kind below which nodes count as badly placed, not as reordered.
constexpr double kFewest = 0.1;

/// An edge, a face, or the inside of a cell: positions in the cell.
struct Entity
{
  std::vector<int> corners;
  std::vector<int> nodes; ///< inside of it
};
using Entities = std::vector<Entity>;

/// The edges and faces of a kind of cell that have nodes inside, in VTK's numbering.
Entities EntitiesOf(const CellKind& kind)
{
  const auto cell = MakeCell(kind);
  Entities entities;
  std::set<int> corners;
  std::set<int> seen;
  const auto add = [&](vtkCell* part)
  {
    Entity entity;
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const int position = static_cast<int>(part->GetPointId(i));
      if (corners.contains(position))
      {
        entity.corners.push_back(position);
      }
      else if (seen.insert(position).second)
      {
        entity.nodes.push_back(position);
      }
    }
    if (!entity.nodes.empty())
    {
      entities.push_back(std::move(entity));
    }
  };
  for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
  {
    vtkCell* edge = cell->GetEdge(e);
    corners.insert(static_cast<int>(edge->GetPointId(0)));
    corners.insert(static_cast<int>(edge->GetPointId(1)));
  }
  for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
  {
    add(cell->GetEdge(e));
  }
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
  {
    add(cell->GetFace(f));
  }
  add(cell);
  return entities;
}

/// The entity that the nodes of each entity fit; empty: their own, or no unique one.
using Order = std::vector<std::size_t>;

Order FittingOrder(const Entities& entities, const std::vector<Vec3>& points)
{
  const auto mean = [&](const std::vector<int>& positions)
  {
    Vec3 sum(0.0);
    for (const int position : positions)
    {
      sum += points[static_cast<std::size_t>(position)];
    }
    return sum / static_cast<double>(positions.size());
  };
  std::vector<Vec3> places;
  for (const Entity& entity : entities)
  {
    places.push_back(mean(entity.corners));
  }
  Order order(entities.size());
  std::vector<char> taken(entities.size(), 0);
  double own = 0.0;
  double other = 0.0;
  for (std::size_t i = 0; i < entities.size(); ++i)
  {
    const Vec3 nodes = mean(entities[i].nodes);
    std::size_t nearest = i;
    for (std::size_t j = 0; j < entities.size(); ++j)
    {
      if (entities[j].nodes.size() == entities[i].nodes.size() &&
        glm::distance(nodes, places[j]) < glm::distance(nodes, places[nearest]))
      {
        nearest = j;
      }
    }
    if (taken[nearest] != 0)
    {
      return {};
    }
    taken[nearest] = 1;
    order[i] = nearest;
    if (nearest != i)
    {
      own += glm::distance(nodes, places[i]);
      other += glm::distance(nodes, places[nearest]);
    }
  }
  return own > kMuchNearer * other ? order : Order();
}

std::string Positions(const std::vector<int>& nodes)
{
  return nodes.size() == 1 ? std::to_string(nodes[0])
                           : std::to_string(*std::ranges::min_element(nodes)) + " to " +
      std::to_string(*std::ranges::max_element(nodes));
}

/// Positions of nodes by VTK's positions, where both differ.
using Moves = std::map<int, int>;

/// The program that writes nodes in this order; empty: unknown.
std::string ProgramOf(const CellKind& kind, const Moves& moves)
{
  static const Moves exodusHexahedron{ { 12, 16 }, { 13, 17 }, { 14, 18 }, { 15, 19 }, { 16, 12 },
    { 17, 13 }, { 18, 14 }, { 19, 15 } };
  static const Moves exodusWedge{ { 9, 12 }, { 10, 13 }, { 11, 14 }, { 12, 9 }, { 13, 10 },
    { 14, 11 } };
  static const Moves gmshHexahedron{ { 9, 11 }, { 10, 16 }, { 11, 9 }, { 12, 17 }, { 13, 10 },
    { 14, 18 }, { 15, 19 }, { 16, 12 }, { 17, 15 }, { 18, 13 }, { 19, 14 } };
  static const Moves gmshWedge{ { 7, 8 }, { 8, 12 }, { 9, 7 }, { 10, 13 }, { 11, 14 }, { 12, 9 },
    { 13, 11 }, { 14, 10 } };
  static const Moves gmshTetrahedron{ { 8, 9 }, { 9, 8 } };
  const auto contains = [&moves](const Moves& some)
  {
    return std::ranges::all_of(some,
      [&](const auto& move)
      { return moves.contains(move.first) && moves.at(move.first) == move.second; });
  };
  const int corners = CellDimension(kind.type) == 3 ? kind.points : 0;
  if ((corners == 20 || corners == 27) && contains(exodusHexahedron))
  {
    return "Abaqus and Exodus";
  }
  if ((corners == 15 || corners == 18) && contains(exodusWedge))
  {
    return "Exodus";
  }
  if (((corners == 20 || corners == 27) && contains(gmshHexahedron)) ||
    ((corners == 15 || corners == 18) && contains(gmshWedge)) ||
    (corners == 10 && contains(gmshTetrahedron)))
  {
    return "Gmsh";
  }
  if (kind.type == VTK_LAGRANGE_HEXAHEDRON || kind.type == VTK_BEZIER_HEXAHEDRON)
  {
    return "VTK 8, in which VTK's own reader leaves old files of several pieces (PixelExact's "
           "readers do not)";
  }
  return {};
}

struct Misplaced
{
  int cells = 0;
  std::int64_t first = 0;
};

std::string Describe(const CellKind& kind, const Entities& entities, const Order& order,
  const Misplaced& misplaced, int all)
{
  Moves moves;
  std::string from;
  std::string to;
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (order[i] != i)
    {
      moved.push_back(i);
    }
  }
  std::ranges::sort(moved, {}, [&](std::size_t i) { return entities[i].nodes.front(); });
  for (const std::size_t i : moved)
  {
    const auto& nodes = entities[i].nodes;
    const auto& fitting = entities[order[i]].nodes;
    from += (from.empty() ? "" : ", ") + Positions(nodes);
    to += (to.empty() ? "" : ", ") + Positions(fitting);
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      moves[nodes[n]] = fitting[n];
    }
  }
  const std::string program = ProgramOf(kind, moves);
  return "In " + std::to_string(misplaced.cells) + " of " + Counted(all, "cell") + " of type " +
    CellTypeName(kind.type) + " (first: cell " + std::to_string(misplaced.first) +
    "; judged from samples) the mid nodes fit other edges or faces: they are not in VTK's order. "
    "The "
    "nodes at " +
    from + " (counted from 0) belong to " + to +
    (program.empty() ? "" : "; that is the order of " + program) +
    ". Maps and values of these cells are wrong, and their folds are no fault of the mesh. Move "
    "the "
    "nodes within the connectivity, or read the file of the program that made the mesh.";
}
} // namespace

void DiagnoseNodeOrder(const SourceMesh& source, std::vector<std::string>& lines)
{
  std::map<const CellBasis*, Entities> entitiesOf;
  std::map<const CellBasis*, int> cells;
  std::map<std::pair<const CellBasis*, Order>, Misplaced> found;
  const auto xyz = source.Coordinates();
  std::vector<Vec3> points;
  const int step = source.Elements() / kMaxExamined + 1;
  for (int e = 0; e < source.Elements(); e += step)
  {
    const CellBasis& basis = source.Basis(e);
    const auto [known, isNew] = entitiesOf.try_emplace(&basis);
    if (isNew)
    {
      known->second = EntitiesOf(basis.kind);
    }
    const Entities& entities = known->second;
    if (entities.size() < 2)
    {
      continue;
    }
    points.clear();
    for (const auto p : source.Points(e))
    {
      const double* x = &xyz[3 * static_cast<std::size_t>(p)];
      points.emplace_back(x[0], x[1], x[2]);
    }
    ++cells[&basis];
    if (const Order order = FittingOrder(entities, points); !order.empty())
    {
      auto& misplaced = found[{ &basis, order }];
      misplaced.first = misplaced.cells++ == 0 ? source.Number(e) : misplaced.first;
    }
  }
  for (const auto& [of, misplaced] : found)
  {
    const auto& [basis, order] = of;
    if (misplaced.cells > kFewest * cells[basis])
    {
      lines.push_back(Describe(basis->kind, entitiesOf[basis], order, misplaced, cells[basis]));
    }
  }
}

std::vector<std::string> DiagnoseSameCells(vtkUnstructuredGrid* grid)
{
  const auto groups = SameCells(std::span(&grid, 1));
  if (groups.empty())
  {
    return {};
  }
  const auto& first = groups.front();
  return { Counted(groups.size(), "cell") + " that the grid has more than once (first: cells " +
    std::to_string(first[0].cell) + " and " + std::to_string(first[1].cell) +
    "): integrals count each time. Take the copies out, or mark them (vtkGhostType)." };
}
} // namespace pixelexact
