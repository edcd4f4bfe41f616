// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/PatchNumbering.h"

#include "Formats/MFEM/Meshes/MeshFile.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
/// Visits a grid's points, the first direction fastest.
template <class Visit>
void ForGrid(const std::array<int, 3>& counts, Visit&& visit)
{
  for (int k = 0; k < counts[2]; ++k)
  {
    for (int j = 0; j < counts[1]; ++j)
    {
      for (int i = 0; i < counts[0]; ++i)
      {
        visit(std::array{ i, j, k });
      }
    }
  }
}

std::size_t IndexIn(const std::array<int, 3>& counts, const std::array<int, 3>& at)
{
  return (static_cast<std::size_t>(at[2]) * counts[1] + at[1]) * counts[0] + at[0];
}

/// The corner that has this vertex.
int CornerOf(const Cell& patch, int vertex)
{
  return static_cast<int>(std::ranges::find(patch.vertices, vertex) - patch.vertices.begin());
}

/// The vertices of a boundary patch as MFEM leaves them: outer ones are turned so that they go
/// round as the side of their patch does.
std::array<int, 4> TurnedBoundary(const PatchTopology& topology, std::size_t boundary)
{
  std::array<int, 4> seen{};
  std::copy_n(topology.boundary[boundary].vertices.begin(), 4, seen.begin());
  if (topology.boundarySides[boundary].size() > 1)
  {
    return seen;
  }
  if (topology.dimension == 2)
  {
    const Cell& patch = topology.patches[topology.boundarySides[boundary].front().patch];
    for (const auto& [from, to] : TableOf(patch.geometry).edges)
    {
      if (patch.vertices.at(from) == seen[1] && patch.vertices.at(to) == seen[0])
      {
        std::swap(seen[0], seen[1]);
        break;
      }
    }
    return seen;
  }
  const auto& base = topology.faces[static_cast<std::size_t>(topology.FindFace(seen))];
  const auto first = static_cast<std::size_t>(std::ranges::find(seen, base[0]) - seen.begin());
  if (seen.at((first + 1) % 4) != base[1])
  {
    std::swap(seen[0], seen[2]);
  }
  return seen;
}
} // namespace

PatchNumbering::PatchNumbering(const PatchTopology& topology, std::vector<int> counts)
  : Topology(topology)
  , Along(std::move(counts))
  , Numbers(topology.vertices)
{
  const auto inside = [this](int a, int b)
  {
    const auto edge = static_cast<std::size_t>(Topology.FindEdge(a, b));
    return static_cast<std::int64_t>(
      Along[static_cast<std::size_t>(Topology.knots[edge].vector)] - 2);
  };
  for (const auto& [a, b] : topology.edges)
  {
    FirstOnEdge.push_back(Numbers);
    Numbers += inside(a, b);
  }
  for (const auto& face : topology.faces)
  {
    FirstOnFace.push_back(Numbers);
    Numbers += inside(face[0], face[1]) * inside(face[0], face[3]);
  }
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    FirstInPatch.push_back(Numbers);
    std::int64_t own = 1;
    const Counts along = CountsOf(p);
    for (int d = 0; d < topology.dimension; ++d)
    {
      own *= along.at(d) - 2;
    }
    Numbers += own;
  }
}

PatchNumbering::Counts PatchNumbering::CountsOf(std::size_t patch) const
{
  Counts counts{ 1, 1, 1 };
  for (int d = 0; d < Topology.dimension; ++d)
  {
    counts.at(d) = Along[static_cast<std::size_t>(Topology.lines[patch].at(d).vector)];
  }
  return counts;
}

int PatchNumbering::OnEdge(int a, int b, int n) const
{
  const auto edge = static_cast<std::size_t>(Topology.FindEdge(a, b));
  const int inside = Along[static_cast<std::size_t>(Topology.knots[edge].vector)] - 2;
  return static_cast<int>(FirstOnEdge[edge]) + (a < b ? n : inside - 1 - n);
}

int PatchNumbering::OnFace(const Cell& patch, const std::array<int, 3>& ends,
  const std::array<int, 2>& directions, const std::array<int, 2>& at) const
{
  std::array<int, 4> corners{};
  for (int k = 0; k < 4; ++k)
  {
    std::array<int, 3> corner = ends;
    corner.at(directions[0]) = k % 2;
    corner.at(directions[1]) = k / 2;
    corners.at(k) = patch.vertices.at(CornerAt(corner));
  }
  const auto number = static_cast<std::size_t>(Topology.FindFace(corners));
  const auto& base = Topology.faces[number];
  // The axes go from the face's first vertex to its second and to its fourth.
  const std::array<int, 3> origin = EndsOf(CornerOf(patch, base[0]));
  std::array<int, 2> place{};
  std::array<int, 2> inside{};
  for (int side = 0; side < 2; ++side)
  {
    const int to = side == 0 ? base[1] : base[3];
    const std::array<int, 3> end = EndsOf(CornerOf(patch, to));
    const int which = end.at(directions[0]) != origin.at(directions[0]) ? 0 : 1;
    const auto edge = static_cast<std::size_t>(Topology.FindEdge(base[0], to));
    inside.at(side) = Along[static_cast<std::size_t>(Topology.knots[edge].vector)] - 2;
    place.at(side) =
      origin.at(directions.at(which)) == 0 ? at.at(which) : inside.at(side) - 1 - at.at(which);
  }
  return static_cast<int>(FirstOnFace[number]) + place[0] + place[1] * inside[0];
}

std::vector<int> PatchNumbering::GridOf(std::size_t patch) const
{
  const Counts counts = CountsOf(patch);
  const Cell& cell = Topology.patches[patch];
  std::vector<int> grid;
  grid.reserve(static_cast<std::size_t>(counts[0]) * counts[1] * counts[2]);
  int own = static_cast<int>(FirstInPatch[patch]);
  ForGrid(counts,
    [&](const std::array<int, 3>& at)
    {
      std::array<int, 3> ends{};
      std::vector<int> inside;
      for (int d = 0; d < Topology.dimension; ++d)
      {
        ends.at(d) = at.at(d) == counts.at(d) - 1 ? 1 : 0;
        if (at.at(d) > 0 && ends.at(d) == 0)
        {
          inside.push_back(d);
        }
      }
      if (inside.empty())
      {
        grid.push_back(cell.vertices.at(CornerAt(ends)));
      }
      else if (static_cast<int>(inside.size()) == Topology.dimension)
      {
        grid.push_back(own++);
      }
      else if (inside.size() == 1)
      {
        std::array<int, 3> end = ends;
        end.at(inside[0]) = 1;
        grid.push_back(OnEdge(
          cell.vertices.at(CornerAt(ends)), cell.vertices.at(CornerAt(end)), at.at(inside[0]) - 1));
      }
      else
      {
        grid.push_back(OnFace(
          cell, ends, { inside[0], inside[1] }, { at.at(inside[0]) - 1, at.at(inside[1]) - 1 }));
      }
    });
  return grid;
}

PatchNumbering::Boundary PatchNumbering::BoundaryOf(std::size_t boundary) const
{
  const PatchTopology::Side& side = Topology.boundarySides[boundary].front();
  const Cell& patch = Topology.patches[side.patch];
  const std::array<int, 4> corners = TurnedBoundary(Topology, boundary);
  const Counts counts = CountsOf(side.patch);
  const std::vector<int> all = GridOf(side.patch);
  // The patch's directions from the first vertex to the second, and from it to the third.
  const auto directionOf = [&](int from, int to)
  {
    const std::array<int, 3> a = EndsOf(CornerOf(patch, from));
    const std::array<int, 3> b = EndsOf(CornerOf(patch, to));
    return a[0] != b[0] ? 0 : a[1] != b[1] ? 1 : 2;
  };
  const std::array directions{ directionOf(corners[0], corners[1]),
    Topology.dimension == 3 ? directionOf(corners[1], corners[2]) : -1 };
  Boundary found;
  for (std::size_t k = 0; k < 2 && directions.at(k) >= 0; ++k)
  {
    found.vectors.at(k) = Topology.lines[side.patch].at(directions.at(k)).vector;
    found.counts.at(k) = counts.at(directions.at(k));
  }
  ForGrid({ found.counts[0], found.counts[1], 1 },
    [&](const std::array<int, 3>& at)
    {
      std::array<int, 3> place{};
      place.at(side.direction) = side.end == 0 ? 0 : counts.at(side.direction) - 1;
      for (std::size_t k = 0; k < 2 && directions.at(k) >= 0; ++k)
      {
        const int d = directions.at(k);
        place.at(d) =
          Topology.lines[side.patch].at(d).isReversed ? counts.at(d) - 1 - at.at(k) : at.at(k);
      }
      found.grid.push_back(all[IndexIn(counts, place)]);
    });
  return found;
}

MeshFile MakeGridMesh(
  const PatchTopology& topology, const PatchNumbering& vertices, std::vector<GridPlace>& places)
{
  MeshFile mesh;
  mesh.dimension = topology.dimension;
  mesh.vertices = static_cast<int>(vertices.Size());
  std::vector<std::vector<int>> grids;
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    const Cell& patch = topology.patches[p];
    const auto counts = vertices.CountsOf(p);
    const auto& grid = grids.emplace_back(vertices.GridOf(p));
    ForGrid({ counts[0] - 1, counts[1] - 1, std::max(counts[2] - 1, 1) },
      [&](const std::array<int, 3>& at)
      {
        Cell& cell = mesh.elements.emplace_back(Cell{ patch.geometry, patch.attribute, {} });
        for (int corner = 0; corner < TableOf(patch.geometry).vertices; ++corner)
        {
          const std::array<int, 3> ends = EndsOf(corner);
          cell.vertices.at(corner) =
            grid[IndexIn(counts, { at[0] + ends[0], at[1] + ends[1], at[2] + ends[2] })];
        }
        places.push_back({ p, at });
      });
  }
  for (std::size_t b = 0; b < topology.boundary.size(); ++b)
  {
    const PatchTopology::Side& side = topology.boundarySides[b].front();
    const auto counts = vertices.CountsOf(side.patch);
    std::array<int, 3> cells{};
    for (int d = 0; d < 3; ++d)
    {
      cells.at(d) = d == side.direction ? 1 : std::max(counts.at(d) - 1, 1);
    }
    const Cell& patch = topology.patches[side.patch];
    const LocalFace* face = nullptr;
    std::vector<int> corners; // of the side, going round
    for (const LocalFace& local : TableOf(patch.geometry).faces)
    {
      if (std::ranges::all_of(
            local.vertices, [&](int v) { return EndsOf(v).at(side.direction) == side.end; }))
      {
        face = &local;
      }
    }
    if (face)
    {
      corners.assign(face->vertices.begin(), face->vertices.end());
    }
    else
    {
      for (int v = 0; v < 4; ++v)
      {
        if (EndsOf(v).at(side.direction) == side.end)
        {
          corners.push_back(v);
        }
      }
    }
    ForGrid(cells,
      [&](std::array<int, 3> at)
      {
        at.at(side.direction) = side.end == 0 ? 0 : counts.at(side.direction) - 2;
        Cell& cell = mesh.boundary.emplace_back(
          Cell{ topology.boundary[b].geometry, topology.boundary[b].attribute, {} });
        for (std::size_t k = 0; k < corners.size(); ++k)
        {
          const std::array<int, 3> ends = EndsOf(corners[k]);
          cell.vertices.at(k) = grids[side.patch][IndexIn(
            counts, { at[0] + ends[0], at[1] + ends[1], at[2] + ends[2] })];
        }
      });
  }
  return mesh;
}
} // namespace pixelexact::mfem
