// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/UnknownOrders.h"

namespace pixelexact::mfem
{
namespace
{
int Triangular(int n)
{
  return n > 0 ? n * (n + 1) / 2 : 0;
}

/// The number of unknowns inside an element of order p whose unknowns form a full lattice: the size
/// of the lattice without the points on the element's boundary.
int LatticeUnknowns(Geometry geometry, int p, PyramidSpace pyramid)
{
  const int n = p + 1; // lattice points per edge
  switch (geometry)
  {
    case Geometry::Point:
      return 1;
    case Geometry::Segment:
      return n;
    case Geometry::Triangle:
      return Triangular(n);
    case Geometry::Square:
      return n * n;
    case Geometry::Tetrahedron:
      return n * (n + 1) * (n + 2) / 6;
    case Geometry::Cube:
      return n * n * n;
    case Geometry::Prism:
      return Triangular(n) * n;
    default:
      return pyramid == PyramidSpace::Bergot ? n * (n + 1) * (2 * n + 1) / 6 : n * n * n;
  }
}

int H1Unknowns(Geometry geometry, int p, PyramidSpace pyramid)
{
  switch (geometry)
  {
    case Geometry::Point:
      return 1;
    case Geometry::Triangle:
      return Triangular(p - 2);
    case Geometry::Tetrahedron:
      return (p - 1) * (p - 2) * (p - 3) / 6;
    case Geometry::Prism:
      return Triangular(p - 2) * (p - 1);
    case Geometry::Pyramid:
      return pyramid == PyramidSpace::Bergot ? (p - 1) * (p - 2) * (2 * p - 3) / 6
                                             : (p - 1) * (p - 1) * (p - 1);
    default: // segment, square, cube
      return LatticeUnknowns(geometry, p - 2, pyramid);
  }
}

int HCurlUnknowns(Geometry geometry, int p)
{
  const int m = p - 1;
  switch (geometry)
  {
    case Geometry::Point:
      return 0;
    case Geometry::Segment:
      return p;
    case Geometry::Triangle:
      return p * m;
    case Geometry::Square:
      return 2 * p * m;
    case Geometry::Tetrahedron:
      return p * m * (p - 2) / 2;
    case Geometry::Prism:
      return p * m * (3 * p - 4) / 2;
    default: // cube, pyramid
      return 3 * p * m * m;
  }
}

/// The number of H(div) unknowns inside an entity of a plane mesh.
int PlaneHDivUnknowns(Geometry geometry, int p)
{
  switch (geometry)
  {
    case Geometry::Segment:
      return p + 1;
    case Geometry::Triangle:
      return p * (p + 1);
    case Geometry::Square:
      return 2 * p * (p + 1);
    default:
      return 0;
  }
}

int HDivUnknowns(Geometry geometry, int p)
{
  const int n = p + 1;
  switch (geometry)
  {
    case Geometry::Point:
    case Geometry::Segment:
      return 0;
    case Geometry::Triangle:
      return n * (n + 1) / 2;
    case Geometry::Square:
      return n * n;
    case Geometry::Tetrahedron:
      return p * n * (p + 2) / 2;
    case Geometry::Prism:
      return p * n * (3 * p + 4) / 2;
    default: // cube, pyramid
      return 3 * p * n * n;
  }
}

/// Whether the geometry is that of an element, not that of a face or an edge.
bool IsElement(Geometry geometry, int dimension)
{
  const bool isSolid = geometry >= Geometry::Tetrahedron;
  return dimension == 3 ? isSolid : geometry == Geometry::Triangle || geometry == Geometry::Square;
}

int DiscontinuousUnknowns(const CollectionName& name, Geometry geometry)
{
  if (!IsElement(geometry, name.dimension))
  {
    return 0;
  }
  // MFEM's Bernstein functions on pyramids span Bergot's space. Legacy pyramids have orders 0 and
  // 1; order 1 has five functions.
  const bool bergot = name.closed == LineBasis::Positive || name.legacy;
  return LatticeUnknowns(geometry, name.order, bergot ? PyramidSpace::Bergot : name.pyramid);
}

/// The index of (a, b) in a triangular lattice of n points per edge, a fastest.
int TrianglePlace(int n, int a, int b)
{
  return Triangular(n) - Triangular(n - b) + a;
}

/// The entity's lattice point that corresponds to the element's own (i, j).
std::array<int, 2> SeenInTriangle(int n, int i, int j, int orientation)
{
  const int k = n - 1 - i - j;
  const std::array<std::array<int, 2>, 6> seen{ { { i, j }, { k, j }, { k, i }, { i, k }, { j, k },
    { j, i } } };
  return seen[orientation];
}

/// The orientation of a square: which of the entity's axes lies along the element's first, and
/// which of the element's axes are reversed.
struct Turn
{
  bool swapped;
  bool firstBack;
  bool secondBack;
};

constexpr std::array<Turn, 8> kTurns{ { { false, false, false }, { true, false, false },
  { true, true, false }, { false, true, false }, { false, true, true }, { true, true, true },
  { true, false, true }, { false, false, true } } };

/// The order of unknowns in a lattice. With `normal`, odd orientations have the sign of the face's
/// normal.
std::vector<int> LatticeOrder(Geometry geometry, int n, int o, bool normal)
{
  std::vector<int> order;
  const auto put = [&](int place) { order.push_back(normal && o % 2 == 1 ? -1 - place : place); };
  for (int j = 0; j < n; ++j)
  {
    if (geometry == Geometry::Triangle)
    {
      for (int i = 0; i + j < n; ++i)
      {
        const auto [a, b] = SeenInTriangle(n, i, j, o);
        put(TrianglePlace(n, a, b));
      }
      continue;
    }
    for (int i = 0; i < n; ++i)
    {
      const Turn turn = kTurns[o];
      const int a = turn.firstBack ? n - 1 - i : i;
      const int b = turn.secondBack ? n - 1 - j : j;
      put(turn.swapped ? b + a * n : a + b * n);
    }
  }
  return order;
}

/// The order of the two tangential unknowns at each point of a triangle.
std::vector<int> TangentTriangleOrder(int p, int o)
{
  std::vector<int> order;
  for (const int point : LatticeOrder(Geometry::Triangle, p - 1, o, false))
  {
    order.push_back(2 * point);
    order.push_back(2 * point + 1);
  }
  return order;
}

/// The order of a square's tangential unknowns: along the first axis, p along it and p - 1 across,
/// then along the second.
std::vector<int> TangentSquareOrder(int p, int o)
{
  const int half = p * (p - 1);
  const Turn turn = kTurns[o];
  std::vector<int> order(2 * std::size_t(half));
  const auto place = [p, half](int axis, int along, int across)
  { return axis == 0 ? along + across * p : half + across + along * (p - 1); };
  for (int axis = 0; axis < 2; ++axis)
  {
    const bool alongBack = axis == 0 ? turn.firstBack : turn.secondBack;
    const bool acrossBack = axis == 0 ? turn.secondBack : turn.firstBack;
    for (int across = 0; across < p - 1; ++across)
    {
      for (int along = 0; along < p; ++along)
      {
        const int seen = place(turn.swapped ? 1 - axis : axis, alongBack ? p - 1 - along : along,
          acrossBack ? p - 2 - across : across);
        order[place(axis, along, across)] = alongBack ? -1 - seen : seen;
      }
    }
  }
  return order;
}

std::vector<int> SegmentOrder(int n, int o, bool tangent)
{
  std::vector<int> order(n);
  for (int i = 0; i < n; ++i)
  {
    const int back = n - 1 - i;
    order[i] = o == 0 ? i : tangent ? -1 - back : back;
  }
  return order;
}

std::vector<int> Identity(int n)
{
  std::vector<int> order(n);
  for (int i = 0; i < n; ++i)
  {
    order[i] = i;
  }
  return order;
}
} // namespace

int EntityUnknowns(const CollectionName& name, Geometry geometry)
{
  if (!name.shared)
  {
    return DiscontinuousUnknowns(name, geometry);
  }
  switch (name.continuity)
  {
    case Continuity::HCurl:
      return HCurlUnknowns(geometry, name.order);
    case Continuity::HDiv:
      return name.dimension == 2 ? PlaneHDivUnknowns(geometry, name.order)
                                 : HDivUnknowns(geometry, name.order);
    default:
      return H1Unknowns(geometry, name.order,
        name.closed == LineBasis::Positive ? PyramidSpace::Bergot : name.pyramid);
  }
}

int Orientations(Geometry geometry)
{
  switch (geometry)
  {
    case Geometry::Segment:
      return 2;
    case Geometry::Triangle:
      return 6;
    case Geometry::Square:
      return 8;
    default:
      return 1;
  }
}

std::vector<int> EntityOrder(const CollectionName& name, Geometry geometry, int o)
{
  const int unknowns = EntityUnknowns(name, geometry);
  if (Orientations(geometry) == 1 || unknowns == 0)
  {
    return Identity(unknowns);
  }
  const int p = name.order;
  const bool tangent = name.continuity == Continuity::HCurl;
  if (geometry == Geometry::Segment)
  {
    // Normals of plane edges change sign with the edge's orientation.
    return SegmentOrder(unknowns, o, tangent || name.continuity == Continuity::HDiv);
  }
  if (tangent)
  {
    return geometry == Geometry::Triangle ? TangentTriangleOrder(p, o) : TangentSquareOrder(p, o);
  }
  if (name.continuity == Continuity::HDiv)
  {
    return LatticeOrder(geometry, p + 1, o, true);
  }
  return LatticeOrder(geometry, geometry == Geometry::Triangle ? p - 2 : p - 1, o, false);
}

std::array<double, 4> TangentMixing(int orientation)
{
  static constexpr std::array<std::array<double, 4>, 6> kMixing{ { { 1, 0, 0, 1 }, { -1, 0, -1, 1 },
    { -1, 1, -1, 0 }, { 1, -1, 0, -1 }, { 0, -1, 1, -1 }, { 0, 1, 1, 0 } } };
  return kMixing[orientation];
}
} // namespace pixelexact::mfem
