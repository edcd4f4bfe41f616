// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Meshes/MeshFile.h"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace pixelexact::mfem
{
/// An element's relation to one of its edges or faces.
struct Incidence
{
  int entity = 0;
  /// Edges: +1 from the lower vertex number to the higher, -1 otherwise. Faces: MFEM's number of
  /// the permutation from the face's vertices, as its first element has them, to this element's.
  int orientation = 0;
};

/// Edges and faces of a mesh, numbered as in MFEM: in the order of their first element. Where
/// elements of different refinement meet, each has its own faces.
class Topology
{
public:
  explicit Topology(const MeshFile& mesh);
  /// Constructs an empty topology, for spaces without unknowns on edges and faces.
  Topology() = default;

  /// Frees the memory that only FindFace needs. FindFace must not be called afterwards.
  void ForgetVertices();

  [[nodiscard]] int Edges() const { return EdgeCount; }
  [[nodiscard]] int Faces() const { return static_cast<int>(FaceGeometries.size()); }
  /// The number of faces (of plane elements: edges) that belong to one element only.
  [[nodiscard]] int BorderFaces() const { return BorderCount; }
  [[nodiscard]] Geometry FaceGeometry(int face) const { return FaceGeometries[face]; }
  [[nodiscard]] std::span<const Incidence> EdgesOf(std::size_t element) const;
  [[nodiscard]] std::span<const Incidence> FacesOf(std::size_t element) const;

  /// An element that has a face, and the face's number in it; for plane elements the edge's.
  struct Owner
  {
    int element = -1;
    int localFace = -1;
  };
  /// The first two elements that have a face with the given vertices, or plane elements that have
  /// an edge with these two; empty where none has.
  [[nodiscard]] std::span<const Owner> FindFace(std::span<const int> vertices) const;

private:
  using FaceKey = std::array<int, 4>;
  struct Owners
  {
    std::array<Owner, 2> list;
    int count = 0;

    void Add(const Owner& owner);
    [[nodiscard]] std::span<const Owner> Get() const { return std::span(list).first(count); }
  };
  struct Face
  {
    FaceKey vertices; ///< in the first element's order; the fourth is -1 for triangles
    Owners owners;
  };
  static FaceKey KeyOf(std::span<const int> vertices);
  void AddEdges(const Cell& cell, int element);
  void AddFaces(const Cell& cell, int element);

  std::map<std::array<int, 2>, int> EdgeOf;
  int EdgeCount = 0;
  int BorderCount = 0;
  std::vector<Owners> EdgeOwners; ///< filled for plane elements only
  std::map<FaceKey, int> FaceOf;
  std::vector<Face> FaceList;
  std::vector<Geometry> FaceGeometries;
  std::vector<Incidence> EdgeIncidences;
  std::vector<Incidence> FaceIncidences;
  std::vector<std::size_t> FirstEdge; ///< per element, and one more
  std::vector<std::size_t> FirstFace;
};
} // namespace pixelexact::mfem
