// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/PatchTopology.h"

#include "Formats/MFEM/Text/TextScanner.h"

#include <algorithm>
#include <numeric>

namespace pixelexact::mfem
{
namespace
{
// The knot vectors along the edges of a NURBS mesh's patches.

/// The edges of a patch along a direction, from its lower end to its upper one, in MFEM's order.
std::vector<std::array<int, 2>> EdgesAlong(const Cell& patch, int dimension, int direction)
{
  std::vector<std::array<int, 2>> edges;
  for (int i = 0; i < (dimension == 3 ? 8 : 4); ++i)
  {
    // The second direction's edges begin at corners 1, 0, 5 and 4.
    const int corner = direction == 1 ? i ^ 1 : i;
    std::array<int, 3> ends = EndsOf(corner);
    if (ends.at(direction) == 0)
    {
      ends.at(direction) = 1;
      edges.push_back({ patch.vertices.at(corner), patch.vertices.at(CornerAt(ends)) });
    }
  }
  return edges;
}

/// Whether the knot vector of the edge runs from b to a.
bool IsReversed(const PatchTopology& topology, int a, int b)
{
  return topology.knots[static_cast<std::size_t>(topology.FindEdge(a, b))].isReversed == (a < b);
}

/// Derives the knot vectors where the file lists none: edges on opposite sides of a patch share
/// one. Sets `knots` and `vectors`.
void MakeKnotVectors(PatchTopology& topology)
{
  const auto dimension = static_cast<std::size_t>(topology.dimension);
  // A disjoint-set forest of patches and directions. The root of a set is its least member.
  std::vector<std::size_t> parent(topology.patches.size() * dimension);
  std::iota(parent.begin(), parent.end(), std::size_t{ 0 });
  const auto root = [&parent](std::size_t i)
  {
    while (parent[i] != i)
    {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  constexpr std::size_t kUnset = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(topology.edges.size(), kUnset);
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    for (std::size_t d = 0; d < dimension; ++d)
    {
      for (const auto& [a, b] :
        EdgesAlong(topology.patches[p], topology.dimension, static_cast<int>(d)))
      {
        auto& known = first[static_cast<std::size_t>(topology.FindEdge(a, b))];
        known = known == kUnset ? p * dimension + d : known;
        const auto [low, high] = std::minmax({ root(known), root(p * dimension + d) });
        parent[high] = low;
      }
    }
  }
  std::map<std::size_t, int> numbers;
  for (std::size_t i = 0; i < parent.size(); ++i)
  {
    numbers.try_emplace(root(i), static_cast<int>(numbers.size()));
  }
  for (const std::size_t line : first)
  {
    topology.knots.push_back({ numbers.at(root(line)), false });
  }
  topology.vectors = static_cast<int>(numbers.size());
}

/// Turns edges so that all edges of a patch's direction run in one sense, beginning with the last
/// patch, and sets `lines`. Fails through `scanner` where that is impossible.
void OrientKnotVectors(const TextScanner& scanner, PatchTopology& topology)
{
  using Along = std::pair<std::size_t, int>; // patch and direction
  std::vector<std::vector<Along>> users(topology.edges.size());
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    for (int d = 0; d < topology.dimension; ++d)
    {
      for (const auto& [a, b] : EdgesAlong(topology.patches[p], topology.dimension, d))
      {
        users[static_cast<std::size_t>(topology.FindEdge(a, b))].emplace_back(p, d);
      }
    }
  }
  std::vector<bool> isSet(topology.edges.size(), false);
  std::set<Along> done;
  for (std::size_t p = topology.patches.size(); p-- > 0;)
  {
    for (int d = topology.dimension; d-- > 0;)
    {
      std::vector<Along> next{ { p, d } };
      while (!next.empty())
      {
        const Along along = next.back();
        next.pop_back();
        if (!done.insert(along).second)
        {
          continue;
        }
        const auto edges =
          EdgesAlong(topology.patches[along.first], topology.dimension, along.second);
        const auto number = [&](const std::array<int, 2>& edge)
        { return static_cast<std::size_t>(topology.FindEdge(edge[0], edge[1])); };
        const auto known =
          std::ranges::find_if(edges, [&](const auto& edge) { return isSet[number(edge)]; });
        const auto& reference = known == edges.end() ? edges.front() : *known;
        const bool wanted = IsReversed(topology, reference[0], reference[1]);
        for (const auto& edge : edges)
        {
          const std::size_t e = number(edge);
          if (topology.knots[e].vector != topology.knots[number(reference)].vector)
          {
            scanner.Fail("opposite edges of patch " + std::to_string(along.first) +
              " have different knot vectors; the section 'edges' contradicts the elements.");
          }
          if (IsReversed(topology, edge[0], edge[1]) != wanted)
          {
            if (isSet[e])
            {
              scanner.Fail("the knot vectors of patch " + std::to_string(along.first) +
                " cannot run in one sense along opposite edges.");
            }
            topology.knots[e].isReversed = !topology.knots[e].isReversed;
          }
          isSet[e] = true;
          next.insert(next.end(), users[e].begin(), users[e].end());
        }
      }
    }
  }
  for (const Cell& patch : topology.patches)
  {
    auto& lines = topology.lines.emplace_back();
    for (int d = 0; d < topology.dimension; ++d)
    {
      const auto [a, b] = EdgesAlong(patch, topology.dimension, d).front();
      const auto edge = static_cast<std::size_t>(topology.FindEdge(a, b));
      lines.at(d) = { topology.knots[edge].vector, IsReversed(topology, a, b) };
    }
  }
}

constexpr std::size_t kShortestPatch = 8;
constexpr int kNone = -1;

std::span<const int> VerticesOf(const Cell& cell)
{
  return std::span(cell.vertices).first(TableOf(cell.geometry).vertices);
}

std::vector<Cell> ReadCells(TextScanner& scanner, const char* what, Geometry geometry)
{
  const int count = scanner.Count(what, kShortestPatch);
  const int dimension = geometry == Geometry::Cube ? 3 : geometry == Geometry::Square ? 2 : 1;
  std::vector<Cell> cells;
  for (int i = 0; i < count; ++i)
  {
    const Cell& cell = cells.emplace_back(ReadCell(scanner, kMaxVertices, dimension));
    if (cell.geometry != geometry)
    {
      scanner.Fail("a patch of a NURBS mesh, or a side of one, is no segment, square or cube.");
    }
    const auto vertices = VerticesOf(cell);
    if (std::set(vertices.begin(), vertices.end()).size() != vertices.size())
    {
      scanner.Fail("a patch has a vertex twice; split it, so that its corners are distinct.");
    }
  }
  return cells;
}

/// Numbers edges and faces in the order in which patches contain them; edges only where none are
/// known.
void Number(PatchTopology& topology)
{
  const bool hasEdges = !topology.edges.empty();
  for (const Cell& patch : topology.patches)
  {
    const GeometryTable& table = TableOf(patch.geometry);
    for (const auto& [from, to] : table.edges)
    {
      const auto [a, b] = std::minmax({ patch.vertices.at(from), patch.vertices.at(to) });
      if (!hasEdges &&
        topology.edgeOf.try_emplace({ a, b }, static_cast<int>(topology.edges.size())).second)
      {
        topology.edges.push_back({ a, b });
      }
    }
    for (const LocalFace& local : table.faces)
    {
      std::array<int, 4> face{};
      std::ranges::transform(
        local.vertices, face.begin(), [&](int v) { return patch.vertices.at(v); });
      std::array<int, 4> key = face;
      std::ranges::sort(key);
      if (topology.faceOf.try_emplace(key, static_cast<int>(topology.faces.size())).second)
      {
        topology.faces.push_back(face);
      }
    }
  }
}

void ReadEdges(TextScanner& scanner, PatchTopology& topology)
{
  scanner.Expect("edges");
  const int count = scanner.Count("the number of edges", 6);
  for (int i = 0; i < count; ++i)
  {
    const int number = scanner.Integer("an edge's knot vector", -kMaxVertices, kMaxVertices);
    const int a = scanner.Integer("a vertex", 0, kMaxVertices);
    const int b = scanner.Integer("a vertex", 0, kMaxVertices);
    const int vector = number < 0 ? -1 - number : number;
    if (vector >= count)
    {
      scanner.Fail("an edge has knot vector " + std::to_string(vector) + ", but there are only " +
        std::to_string(count) + " edges.");
    }
    topology.vectors = std::max(topology.vectors, vector + 1);
    topology.knots.push_back({ vector, (number < 0) != (a > b) });
    if (a > b)
    {
      topology.listedDownwards.insert(i);
    }
    topology.edges.push_back({ std::min(a, b), std::max(a, b) });
    if (!topology.edgeOf.try_emplace(topology.edges.back(), i).second)
    {
      scanner.Fail("the edge from vertex " + std::to_string(a) + " to " + std::to_string(b) +
        " is there twice.");
    }
  }
}

void RequireEdges(TextScanner& scanner, const PatchTopology& topology)
{
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    const Cell& patch = topology.patches[p];
    for (const auto& [from, to] : TableOf(patch.geometry).edges)
    {
      if (topology.FindEdge(patch.vertices.at(from), patch.vertices.at(to)) == kNone)
      {
        scanner.Fail(
          "patch " + std::to_string(p) + " has an edge that the section 'edges' does not list.");
      }
    }
  }
}

/// Finds the patches' sides that have the vertices of each boundary patch.
void FindSides(TextScanner& scanner, PatchTopology& topology)
{
  std::map<std::vector<int>, std::vector<PatchTopology::Side>> sides;
  for (std::size_t p = 0; p < topology.patches.size(); ++p)
  {
    for (int d = 0; d < topology.dimension; ++d)
    {
      for (const int end : { 0, 1 })
      {
        std::vector<int> key;
        for (int corner = 0; corner < (topology.dimension == 3 ? 8 : 4); ++corner)
        {
          if (EndsOf(corner).at(d) == end)
          {
            key.push_back(topology.patches[p].vertices.at(corner));
          }
        }
        std::ranges::sort(key);
        sides[key].push_back({ p, d, end });
      }
    }
  }
  for (std::size_t b = 0; b < topology.boundary.size(); ++b)
  {
    const auto vertices = VerticesOf(topology.boundary[b]);
    std::vector<int> key(vertices.begin(), vertices.end());
    std::ranges::sort(key);
    const auto found = sides.find(key);
    if (found == sides.end())
    {
      scanner.Fail("boundary patch " + std::to_string(b) + " is no side of a patch.");
    }
    topology.boundarySides.push_back(found->second);
  }
}
} // namespace

int CornerAt(const std::array<int, 3>& ends)
{
  return 4 * ends[2] + (ends[1] == 0 ? ends[0] : 3 - ends[0]);
}

std::array<int, 3> EndsOf(int corner)
{
  const int inPlane = corner % 4;
  return { inPlane == 1 || inPlane == 2 ? 1 : 0, inPlane / 2, corner / 4 };
}

int PatchTopology::FindEdge(int a, int b) const
{
  const auto found = edgeOf.find({ std::min(a, b), std::max(a, b) });
  return found == edgeOf.end() ? kNone : found->second;
}

int PatchTopology::FindFace(std::array<int, 4> corners) const
{
  std::ranges::sort(corners);
  const auto found = faceOf.find(corners);
  return found == faceOf.end() ? kNone : found->second;
}

PatchTopology ReadPatchTopology(TextScanner& scanner)
{
  PatchTopology topology;
  scanner.Expect("dimension");
  topology.dimension = ReadDimension(scanner);
  const bool isSolid = topology.dimension == 3;
  scanner.Expect("elements");
  topology.patches =
    ReadCells(scanner, "the number of patches", isSolid ? Geometry::Cube : Geometry::Square);
  scanner.Expect("boundary");
  topology.boundary = ReadCells(
    scanner, "the number of boundary patches", isSolid ? Geometry::Square : Geometry::Segment);
  ReadEdges(scanner, topology);
  scanner.Expect("vertices");
  topology.vertices = scanner.Integer("the number of vertices", 0, kMaxVertices);
  for (const auto* cells : { &topology.patches, &topology.boundary })
  {
    for (const Cell& cell : *cells)
    {
      if (std::ranges::max(VerticesOf(cell)) >= topology.vertices)
      {
        scanner.Fail("a patch has a vertex beyond the " + std::to_string(topology.vertices) +
          " that there are.");
      }
    }
  }
  const bool hasEdges = !topology.edges.empty();
  Number(topology);
  if (hasEdges)
  {
    RequireEdges(scanner, topology);
  }
  else
  {
    MakeKnotVectors(topology);
  }
  OrientKnotVectors(scanner, topology);
  FindSides(scanner, topology);
  return topology;
}
} // namespace pixelexact::mfem
