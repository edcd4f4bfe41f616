// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Nurbs/PatchTopology.h"

#include "Formats/MFEM/Elements/GeometryTable.h"
#include "Formats/MFEM/Nurbs/PatchKnots.h"
#include "Formats/MFEM/Text/MeshFormat.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
constexpr int kMostVertices = 1 << 30;
constexpr std::size_t kShortestCell = 8;
constexpr int kNone = -1;

std::span<const int> VerticesOf(const Cell& cell)
{
  return std::span(cell.vertices).first(TableOf(cell.geometry).vertices);
}

std::vector<Cell> ReadCells(TextScanner& scanner, const char* what, Geometry geometry)
{
  const int count = scanner.Count(what, kShortestCell);
  const int dimension = geometry == Geometry::Cube ? 3 : geometry == Geometry::Square ? 2 : 1;
  std::vector<Cell> cells;
  for (int i = 0; i < count; ++i)
  {
    const Cell& cell = cells.emplace_back(ReadCell(scanner, kMostVertices, dimension));
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

/// Edges and faces in the order in which patches come upon them; edges only where none are known.
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
    const int number = scanner.Integer("an edge's knot vector", -kMostVertices, kMostVertices);
    const int a = scanner.Integer("a vertex", 0, kMostVertices);
    const int b = scanner.Integer("a vertex", 0, kMostVertices);
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

/// Of each boundary patch, the sides of patches with its vertices.
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
  topology.vertices = scanner.Integer("the number of vertices", 0, kMostVertices);
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
