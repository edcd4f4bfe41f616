// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/UnknownOrders.h"

#include <utility>

namespace pixelexact::mfem
{
namespace
{
/// The points of an element whose edges have p + 1, entity by entity. Corners are lattice points;
/// an entity's points count from its first corner.
class Entities
{
public:
  explicit Entities(int p)
    : Order(p)
  {
  }

  void Vertex(const LatticePoint& corner) { Points.push_back(Scaled(corner)); }

  void Edge(const LatticePoint& from, const LatticePoint& to)
  {
    for (int i = 1; i < Order; ++i)
    {
      Points.push_back(Moved(from, { { to, i } }));
    }
  }

  void Triangle(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
  {
    for (int j = 1; j < Order; ++j)
    {
      for (int i = 1; i + j < Order; ++i)
      {
        Points.push_back(Moved(a, { { b, i }, { c, j } }));
      }
    }
  }

  /// `b` and `d` are the neighbours of `a`.
  void Square(const LatticePoint& a, const LatticePoint& b, const LatticePoint& d)
  {
    for (int j = 1; j < Order; ++j)
    {
      for (int i = 1; i < Order; ++i)
      {
        Points.push_back(Moved(a, { { b, i }, { d, j } }));
      }
    }
  }

  void Point(const LatticePoint& point) { Points.push_back(point); }

  [[nodiscard]] std::vector<LatticePoint> Take() { return std::move(Points); }

private:
  [[nodiscard]] LatticePoint Scaled(const LatticePoint& corner) const
  {
    return { corner[0] * Order, corner[1] * Order, corner[2] * Order };
  }

  /// Steps from a corner towards others.
  [[nodiscard]] LatticePoint Moved(
    const LatticePoint& from, const std::vector<std::pair<LatticePoint, int>>& steps) const
  {
    LatticePoint point = Scaled(from);
    for (const auto& [to, count] : steps)
    {
      for (int d = 0; d < 3; ++d)
      {
        point[d] += count * (to[d] - from[d]);
      }
    }
    return point;
  }

  int Order;
  std::vector<LatticePoint> Points;
};

using LatticeCorner = LatticePoint;

constexpr std::array<LatticeCorner, 4> kTetrahedron{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
  { 0, 0, 1 } } };
constexpr std::array<LatticeCorner, 8> kCube{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };
constexpr std::array<LatticeCorner, 6> kPrism{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 0, 1, 1 } } };

constexpr std::array<LatticeCorner, 5> kPyramid{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
  { 0, 1, 0 }, { 0, 0, 1 } } };

template <std::size_t VertexCount, std::size_t EdgeCount>
Entities VerticesAndEdges(const std::array<LatticeCorner, VertexCount>& corners,
  const std::array<std::array<int, 2>, EdgeCount>& edges, int p)
{
  Entities entities(p);
  for (const LatticeCorner& corner : corners)
  {
    entities.Vertex(corner);
  }
  for (const auto& [from, to] : edges)
  {
    entities.Edge(corners[from], corners[to]);
  }
  return entities;
}

std::vector<LatticePoint> Tetrahedron(int p)
{
  static constexpr std::array<std::array<int, 2>, 6> kEdges{ { { 0, 1 }, { 0, 2 }, { 0, 3 },
    { 1, 2 }, { 1, 3 }, { 2, 3 } } };
  Entities entities = VerticesAndEdges(kTetrahedron, kEdges, p);
  static constexpr std::array<std::array<int, 3>, 4> kFaces{ { { 1, 2, 3 }, { 0, 3, 2 },
    { 0, 1, 3 }, { 0, 2, 1 } } };
  for (const auto& [a, b, c] : kFaces)
  {
    entities.Triangle(kTetrahedron[a], kTetrahedron[b], kTetrahedron[c]);
  }
  for (int k = 1; k < p; ++k)
  {
    for (int j = 1; j + k < p; ++j)
    {
      for (int i = 1; i + j + k < p; ++i)
      {
        entities.Point({ i, j, k });
      }
    }
  }
  return entities.Take();
}

std::vector<LatticePoint> Cube(int p)
{
  static constexpr std::array<std::array<int, 2>, 12> kEdges{ { { 0, 1 }, { 1, 2 }, { 3, 2 },
    { 0, 3 }, { 4, 5 }, { 5, 6 }, { 7, 6 }, { 4, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } };
  Entities entities = VerticesAndEdges(kCube, kEdges, p);
  // A corner and its neighbours in the face.
  static constexpr std::array<std::array<int, 3>, 6> kFaces{ { { 3, 2, 0 }, { 0, 1, 4 },
    { 1, 2, 5 }, { 2, 3, 6 }, { 3, 0, 7 }, { 4, 5, 7 } } };
  for (const auto& [a, b, d] : kFaces)
  {
    entities.Square(kCube[a], kCube[b], kCube[d]);
  }
  for (int k = 1; k < p; ++k)
  {
    for (int j = 1; j < p; ++j)
    {
      for (int i = 1; i < p; ++i)
      {
        entities.Point({ i, j, k });
      }
    }
  }
  return entities.Take();
}

/// MFEM numbers the lower triangle's inside by the face (0, 2, 1), except in Bernstein's basis.
std::vector<LatticePoint> Prism(int p, bool lowerAsUpper)
{
  static constexpr std::array<std::array<int, 2>, 9> kEdges{ { { 0, 1 }, { 1, 2 }, { 2, 0 },
    { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 } } };
  Entities entities = VerticesAndEdges(kPrism, kEdges, p);
  entities.Triangle(kPrism[0], kPrism[lowerAsUpper ? 1 : 2], kPrism[lowerAsUpper ? 2 : 1]);
  entities.Triangle(kPrism[3], kPrism[4], kPrism[5]);
  entities.Square(kPrism[0], kPrism[1], kPrism[3]);
  entities.Square(kPrism[1], kPrism[2], kPrism[4]);
  entities.Square(kPrism[2], kPrism[0], kPrism[5]);
  for (int k = 1; k < p; ++k)
  {
    for (int j = 1; j < p; ++j)
    {
      for (int i = 1; i + j < p; ++i)
      {
        entities.Point({ i, j, k });
      }
    }
  }
  return entities.Take();
}

/// Layer k has p - k + 1 points along x and y. MFEM numbers Bergot's nodes by faces of its own.
std::vector<LatticePoint> Pyramid(int p, bool bergotNodes)
{
  static constexpr std::array<std::array<int, 2>, 8> kEdges{ { { 0, 1 }, { 1, 2 }, { 3, 2 },
    { 0, 3 }, { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } } };
  const auto& v = kPyramid;
  Entities entities = VerticesAndEdges(v, kEdges, p);
  if (bergotNodes)
  {
    entities.Square(v[0], v[1], v[3]);
  }
  else
  {
    entities.Square(v[3], v[2], v[0]);
  }
  static constexpr std::array<std::array<int, 3>, 4> kFaces{ { { 0, 1, 4 }, { 1, 2, 4 },
    { 2, 3, 4 }, { 3, 0, 4 } } };
  static constexpr std::array<std::array<int, 3>, 4> kBergotFaces{ { { 0, 1, 4 }, { 1, 2, 4 },
    { 3, 4, 2 }, { 0, 4, 3 } } };
  for (const auto& [a, b, c] : bergotNodes ? kBergotFaces : kFaces)
  {
    entities.Triangle(v[a], v[b], v[c]);
  }
  for (int k = 1; k < p; ++k)
  {
    for (int j = 1; j + k < p; ++j)
    {
      for (int i = 1; i + k < p; ++i)
      {
        entities.Point({ i, j, k });
      }
    }
  }
  return entities.Take();
}

std::vector<LatticePoint> PlaneTriangle(int p)
{
  static constexpr std::array<std::array<int, 2>, 3> kEdges{ { { 0, 1 }, { 1, 2 }, { 2, 0 } } };
  static constexpr std::array<LatticeCorner, 3> kCorners{ { { 0, 0, 0 }, { 1, 0, 0 },
    { 0, 1, 0 } } };
  Entities entities = VerticesAndEdges(kCorners, kEdges, p);
  entities.Triangle(kCorners[0], kCorners[1], kCorners[2]);
  return entities.Take();
}

std::vector<LatticePoint> PlaneSquare(int p)
{
  static constexpr std::array<std::array<int, 2>, 4> kEdges{ { { 0, 1 }, { 1, 2 }, { 2, 3 },
    { 3, 0 } } };
  static constexpr std::array<LatticeCorner, 4> kCorners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 } } };
  Entities entities = VerticesAndEdges(kCorners, kEdges, p);
  entities.Square(kCorners[0], kCorners[1], kCorners[3]);
  return entities.Take();
}

/// The whole lattice, x fastest.
std::vector<LatticePoint> Lexicographic(Geometry solid, int p)
{
  std::vector<LatticePoint> points;
  const bool isPlane = solid == Geometry::Triangle || solid == Geometry::Square;
  for (int k = 0; k <= (isPlane ? 0 : p); ++k)
  {
    const bool narrows = solid == Geometry::Tetrahedron || solid == Geometry::Pyramid;
    const int rows = narrows ? p - k : p;
    for (int j = 0; j <= rows; ++j)
    {
      const bool square =
        solid == Geometry::Cube || solid == Geometry::Pyramid || solid == Geometry::Square;
      const int last = square ? rows : rows - j;
      for (int i = 0; i <= last; ++i)
      {
        points.push_back({ i, j, k });
      }
    }
  }
  return points;
}
} // namespace

std::vector<LatticePoint> LocalOrder(const CollectionName& name, Geometry solid)
{
  const int p = name.order;
  if (!name.entityOrdered || p == 0)
  {
    return Lexicographic(solid, p);
  }
  if (solid == Geometry::Triangle)
  {
    return PlaneTriangle(p);
  }
  if (solid == Geometry::Square)
  {
    return PlaneSquare(p);
  }
  if (solid == Geometry::Tetrahedron)
  {
    return Tetrahedron(p);
  }
  if (solid == Geometry::Prism)
  {
    return Prism(p, name.closed == LineBasis::Positive);
  }
  if (solid == Geometry::Pyramid)
  {
    return Pyramid(p, name.closed != LineBasis::Positive && name.pyramid == PyramidSpace::Bergot);
  }
  auto points = Cube(p);
  if (name.legacy && p == 3)
  {
    // The inside of "Cubic" goes around each layer.
    const std::size_t inside = points.size() - 8;
    std::swap(points[inside + 2], points[inside + 3]);
    std::swap(points[inside + 6], points[inside + 7]);
  }
  return points;
}
} // namespace pixelexact::mfem
