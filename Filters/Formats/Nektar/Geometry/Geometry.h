// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"
#include "Formats/Nektar/Files/Document.h"
#include "Formats/Nektar/Files/IdMap.h"
#include "Formats/SolverModel.h"

#include <array>
#include <span>
#include <string>
#include <unordered_map>

namespace pixelexact::nektar
{
using Point = std::array<double, 3>;

/// The transform of each point of a geometry, of vertices and curves: scale, then move, then rotate
/// about the z axis.
struct Transform
{
  Point scale{ 1.0, 1.0, 1.0 };
  Point move{};
  double angle = 0.0; ///< in radians

  [[nodiscard]] Point operator()(Point x) const;
  bool operator==(const Transform&) const = default;
};

/// The distribution of a curve's points.
enum class Distribution : std::uint8_t
{
  Equispaced,
  GaussLobatto,
  LobattoChebyshev,
  TriangleEquispaced,
  TriangleElectrostatic,
  TriangleFekete
};

/// Points on a curved edge or face, in its own order.
struct Curve
{
  Distribution distribution = Distribution::Equispaced;
  int order = 1; ///< points along an edge, less one
  std::vector<Point> points;

  bool operator==(const Curve&) const = default;
};

struct Edge
{
  std::array<std::int64_t, 2> vertices{};
  int curve = -1; ///< index in Geometry::curves, or -1

  bool operator==(const Edge&) const = default;
};

/// A face by its edges; triangles have three. Its vertices are in its own order.
struct Face
{
  int corners = 0;
  std::array<std::int64_t, 4> edges{};
  std::array<std::int64_t, 4> vertices{};
  int curve = -1;

  bool operator==(const Face&) const = default;
};

struct Solid
{
  std::int64_t id = 0;
  Shape shape = Shape::Hexahedron;
  std::array<std::int64_t, 6> faces{};

  bool operator==(const Solid&) const = default;
};

struct SolidTag
{
  std::string_view tag;
  Shape shape;
};
inline constexpr SolidTag kSolidTags[] = { { "A", Shape::Tetrahedron }, { "P", Shape::Pyramid },
  { "R", Shape::Prism }, { "H", Shape::Hexahedron } };

/// The elements of plane meshes, as the solids of a slab (bases-and-kernels.md), whose only face is
/// their own.
inline constexpr SolidTag kPlaneTags[] = { { "T", Shape::Prism }, { "Q", Shape::Hexahedron } };

/// The elements of one-dimensional meshes.
inline constexpr std::string_view kLineTag = "S";

/// A session's GEOMETRY, with all references resolved or refused.
struct Geometry
{
  int dimension = 3;   ///< of the elements, 2 or 3
  bool isLine = false; ///< segments along x, as quadrilaterals of a width that means nothing
  IdMap<Point> vertices;
  IdMap<Edge> edges;
  IdMap<Face> faces;
  std::vector<Solid> solids; ///< hexahedra, prisms, pyramids, tetrahedra as the file has them
  IdMap<int> solidOf;        ///< index in solids, by id
  std::vector<Curve> curves;
  /// Per composite: its number, name, and the ids of its solids or faces, in the plane its elements
  /// or edges.
  struct Composite
  {
    int number = 0;
    std::string name;
    bool boundary = false;
    std::vector<std::int64_t> members;
  };
  std::vector<Composite> composites;
  std::vector<std::string> notes; ///< as SolverModel::notes
};

/// Reads the GEOMETRY of each file of a session that has one, as the parts of one mesh (as parallel
/// runs write it): what several of them have must be the same in each. Throws InvalidData and
/// Unsupported.
Geometry ReadGeometry(std::span<const Document* const> session);

/// Adds the vertices, edges, faces and solids of a GEOMETRY to those of other parts of the mesh;
/// what is there already must be the same.
void ReadEntities(const Document& document, const pugi::xml_node& geometry,
  const Transform& transform, Geometry& target);

/// Reads CURVED into the geometry's curves, their points moved as its vertices are, and puts their
/// numbers into its edges and faces.
void ReadCurves(const Document& document, const pugi::xml_node& curved, const Transform& transform,
  Geometry& geometry);

/// Adds the composites of solids and of faces to a geometry whose entities are complete. What
/// another part of the mesh has of the same composite is joined with it.
void ReadComposites(const Document& document, const pugi::xml_node& composites, Geometry& geometry);

/// Elements' faces by their numbers in composites; their attributes are not set yet.
using FaceOwners = std::unordered_multimap<std::int64_t, BoundaryFace>;

/// Turns a geometry's composites into groups and attributes of the model's elements, which are the
/// geometry's in its order. `name`: of the mesh, for notes.
void AddGroups(
  const Geometry& source, const FaceOwners& owners, const std::string& name, SolverModel& model);
} // namespace pixelexact::nektar
