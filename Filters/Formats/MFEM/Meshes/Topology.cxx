// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Meshes/Topology.h"

#include "Formats/MFEM/Meshes/MeshFile.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
/// MFEM's number of the permutation from `base` to `seen`. Vertices that coincide, as in small
/// periodic meshes, leave it ambiguous; the first match counts.
int TriangleOrientation(const std::array<int, 4>& base, const std::array<int, 4>& seen)
{
  if (seen[0] == base[0])
  {
    return seen[1] == base[1] ? 0 : 5;
  }
  if (seen[0] == base[1])
  {
    return seen[1] == base[0] ? 1 : 2;
  }
  return seen[1] == base[0] ? 4 : 3;
}

int SquareOrientation(const std::array<int, 4>& base, const std::array<int, 4>& seen)
{
  const auto i = static_cast<int>(std::ranges::find(seen, base[0]) - seen.begin()) % 4;
  return seen[(i + 1) % 4] == base[1] ? 2 * i : 2 * i + 1;
}
} // namespace

void Topology::Owners::Add(const Owner& owner)
{
  if (count < static_cast<int>(list.size()))
  {
    list[count++] = owner;
  }
}

Topology::FaceKey Topology::KeyOf(std::span<const int> vertices)
{
  FaceKey key{ -1, -1, -1, -1 };
  std::ranges::copy(vertices, key.begin());
  std::ranges::sort(key);
  return key;
}

Topology::Topology(const MeshFile& mesh)
{
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    FirstEdge.push_back(EdgeIncidences.size());
    FirstFace.push_back(FaceIncidences.size());
    AddEdges(mesh.elements[e], static_cast<int>(e));
    AddFaces(mesh.elements[e], static_cast<int>(e));
  }
  FirstEdge.push_back(EdgeIncidences.size());
  FirstFace.push_back(FaceIncidences.size());
  EdgeCount = static_cast<int>(EdgeOf.size());
  BorderCount = static_cast<int>(std::ranges::count(EdgeOwners, 1, &Owners::count) +
    std::ranges::count(FaceList, 1, [](const Face& face) { return face.owners.count; }));
}

void Topology::ForgetVertices()
{
  EdgeOf.clear();
  FaceOf.clear();
  std::vector<Owners>().swap(EdgeOwners);
  std::vector<Face>().swap(FaceList);
}

void Topology::AddEdges(const Cell& cell, int element)
{
  const GeometryTable& table = TableOf(cell.geometry);
  for (std::size_t local = 0; local < table.edges.size(); ++local)
  {
    const int a = cell.vertices[table.edges[local][0]];
    const int b = cell.vertices[table.edges[local][1]];
    const auto [at, isNew] =
      EdgeOf.try_emplace({ std::min(a, b), std::max(a, b) }, static_cast<int>(EdgeOf.size()));
    EdgeIncidences.push_back({ at->second, a < b ? 1 : -1 });
    if (!table.sides.empty())
    {
      EdgeOwners.resize(EdgeOf.size());
      EdgeOwners[at->second].Add({ element, static_cast<int>(local) });
    }
  }
}

void Topology::AddFaces(const Cell& cell, int element)
{
  const auto faces = TableOf(cell.geometry).faces;
  for (std::size_t local = 0; local < faces.size(); ++local)
  {
    const LocalFace& face = faces[local];
    const int corners = TableOf(face.geometry).vertices;
    std::array<int, 4> seen{ -1, -1, -1, -1 };
    for (int k = 0; k < corners; ++k)
    {
      seen[k] = cell.vertices[face.vertices[k]];
    }
    const auto [at, isNew] =
      FaceOf.try_emplace(KeyOf(std::span(seen).first(corners)), static_cast<int>(FaceList.size()));
    if (isNew)
    {
      FaceList.push_back({ seen, {} });
      FaceGeometries.push_back(face.geometry);
    }
    Face& known = FaceList[at->second];
    known.owners.Add({ element, static_cast<int>(local) });
    const auto& base = known.vertices;
    FaceIncidences.push_back({ at->second,
      face.geometry == Geometry::Triangle ? TriangleOrientation(base, seen)
                                          : SquareOrientation(base, seen) });
  }
}

std::span<const Incidence> Topology::EdgesOf(std::size_t element) const
{
  return std::span(EdgeIncidences)
    .subspan(FirstEdge[element], FirstEdge[element + 1] - FirstEdge[element]);
}

std::span<const Incidence> Topology::FacesOf(std::size_t element) const
{
  return std::span(FaceIncidences)
    .subspan(FirstFace[element], FirstFace[element + 1] - FirstFace[element]);
}

std::span<const Topology::Owner> Topology::FindFace(std::span<const int> vertices) const
{
  if (vertices.size() == 2)
  {
    const auto edge =
      EdgeOf.find({ std::min(vertices[0], vertices[1]), std::max(vertices[0], vertices[1]) });
    return edge == EdgeOf.end() || EdgeOwners.empty() ? std::span<const Owner>()
                                                      : EdgeOwners[edge->second].Get();
  }
  const auto found = FaceOf.find(KeyOf(vertices));
  return found == FaceOf.end() ? std::span<const Owner>() : FaceList[found->second].owners.Get();
}
} // namespace pixelexact::mfem
