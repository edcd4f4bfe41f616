// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Files/Document.h"
#include "Formats/Nektar/Files/IdMap.h"
#include "Formats/Nektar/Geometry/Transform.h"

#include "Core/Shape/Shape.h"
#include "Formats/SolverModel.h"

#include <array>
#include <span>

namespace pixelexact::nektar
{
/// How a curve's points are distributed.
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

/// The elements of plane meshes, as the solids of a slab (planar.md), whose only face is their own.
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
} // namespace pixelexact::nektar
