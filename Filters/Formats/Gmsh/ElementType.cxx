// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/ElementType.h"

#include <algorithm>
#include <map>

namespace pixelexact::gmsh
{
namespace
{
/// Types of one kind of element, orders ascending from `order`; 0: the order has no type.
struct Series
{
  int dimension;
  int corners;
  Shape shape;
  int order;
  bool complete;
  std::array<int, 11> numbers;
};

constexpr auto kNone = Shape::Hexahedron;
constexpr Series kSeries[] = {
  { 0, 1, kNone, 0, true, { 15 } },
  { 1, 2, kNone, 1, true, { 1, 8, 26, 27, 28, 62, 63, 64, 65, 66 } },
  { 2, 3, Shape::Prism, 1, true, { 2, 9, 21, 23, 25, 42, 43, 44, 45, 46 } },
  { 2, 3, Shape::Prism, 3, false, { 20, 22, 24, 52, 53, 54, 55, 56 } },
  { 2, 4, Shape::Hexahedron, 1, true, { 3, 10, 36, 37, 38, 47, 48, 49, 50, 51 } },
  { 2, 4, Shape::Hexahedron, 2, false, { 16, 39, 40, 41, 57, 58, 59, 60, 61 } },
  { 3, 4, Shape::Tetrahedron, 1, true, { 4, 11, 29, 30, 31, 71, 72, 73, 74, 75 } },
  { 3, 4, Shape::Tetrahedron, 3, false, { 137, 32, 33, 79, 80, 81, 82, 83 } },
  { 3, 8, Shape::Hexahedron, 1, true, { 5, 12, 92, 93, 94, 95, 96, 97, 98 } },
  { 3, 8, Shape::Hexahedron, 2, false, { 17, 99, 100, 101, 102, 103, 104, 105 } },
  { 3, 6, Shape::Prism, 1, true, { 6, 13, 90, 91, 106, 107, 108, 109, 110 } },
  { 3, 6, Shape::Prism, 2, false, { 18, 111, 112, 113, 114, 115, 116, 117 } },
  { 3, 5, Shape::Pyramid, 1, true, { 7, 14, 118, 119, 120, 121, 122, 123, 124 } },
  { 3, 5, Shape::Pyramid, 2, false, { 19, 125, 126, 127, 128, 129, 130, 131 } },
};

int Edges(const Series& s)
{
  if (s.dimension == 1)
  {
    return 1;
  }
  if (s.dimension == 2)
  {
    return s.corners;
  }
  switch (s.shape)
  {
    case Shape::Tetrahedron:
      return 6;
    case Shape::Hexahedron:
      return 12;
    case Shape::Prism:
      return 9;
    default:
      return 8;
  }
}

int CompleteNodes(const Series& s, int p)
{
  const int n = p + 1;
  if (s.dimension < 3)
  {
    return s.dimension == 0 ? 1 : s.dimension == 1 ? n : s.corners == 3 ? n * (n + 1) / 2 : n * n;
  }
  switch (s.shape)
  {
    case Shape::Tetrahedron:
      return n * (n + 1) * (n + 2) / 6;
    case Shape::Hexahedron:
      return n * n * n;
    case Shape::Prism:
      return n * n * (n + 1) / 2;
    default:
      return n * (n + 1) * (2 * n + 1) / 6;
  }
}

std::map<int, ElementType> MakeTypes()
{
  std::map<int, ElementType> types;
  for (const Series& s : kSeries)
  {
    int order = s.order;
    for (const int number : s.numbers)
    {
      if (number != 0)
      {
        const int nodes = s.complete ? CompleteNodes(s, order) : s.corners + Edges(s) * (order - 1);
        types[number] = { number, s.dimension, s.corners, nodes, order, s.complete, s.shape };
      }
      ++order;
    }
  }
  return types;
}

using Edge = std::array<int, 2>;

/// Vertices at order 1, edges and faces as Gmsh numbers and directs them. A face's inner nodes run
/// from its first corner towards the second, then towards the last.
struct SolidLattice
{
  std::vector<Lattice> vertices;
  std::vector<Edge> edges;
  std::vector<ElementFace> faces;
  int shrink; ///< the interior is an element of an order that is lower by this
};

const SolidLattice& SolidOf(Shape shape)
{
  static const SolidLattice tetrahedron{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 0 }, { 3, 2 }, { 3, 1 } },
    { { { 0, 2, 1, -1 }, 3 }, { { 0, 1, 3, -1 }, 0 }, { { 0, 3, 2, -1 }, 2 },
      { { 3, 1, 2, -1 }, 1 } },
    4 };
  static const SolidLattice hexahedron{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
                                          { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
    { { 0, 1 }, { 0, 3 }, { 0, 4 }, { 1, 2 }, { 1, 5 }, { 2, 3 }, { 2, 6 }, { 3, 7 }, { 4, 5 },
      { 4, 7 }, { 5, 6 }, { 6, 7 } },
    { { { 0, 3, 2, 1 }, 4 }, { { 0, 1, 5, 4 }, 2 }, { { 0, 4, 7, 3 }, 0 }, { { 1, 2, 6, 5 }, 1 },
      { { 2, 3, 7, 6 }, 3 }, { { 4, 5, 6, 7 }, 5 } },
    2 };
  static const SolidLattice prism{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                     { 1, 0, 1 }, { 0, 1, 1 } },
    { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 4 }, { 2, 5 }, { 3, 4 }, { 3, 5 }, { 4, 5 } },
    { { { 0, 2, 1, -1 }, 0 }, { { 3, 4, 5, -1 }, 1 }, { { 0, 1, 4, 3 }, 2 }, { { 0, 3, 5, 2 }, 4 },
      { { 1, 2, 5, 4 }, 3 } },
    3 };
  static const SolidLattice pyramid{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
                                       { 0, 0, 1 } },
    { { 0, 1 }, { 0, 3 }, { 0, 4 }, { 1, 2 }, { 1, 4 }, { 2, 3 }, { 2, 4 }, { 3, 4 } },
    { { { 0, 1, 4, -1 }, 1 }, { { 3, 0, 4, -1 }, 4 }, { { 1, 2, 4, -1 }, 2 },
      { { 2, 3, 4, -1 }, 3 }, { { 0, 3, 2, 1 }, 0 } },
    3 };
  switch (shape)
  {
    case Shape::Tetrahedron:
      return tetrahedron;
    case Shape::Hexahedron:
      return hexahedron;
    case Shape::Prism:
      return prism;
    default:
      return pyramid;
  }
}

/// from + steps times (to - from) / order
Lattice Along(const Lattice& from, const Lattice& to, int order, int steps)
{
  Lattice at = from;
  for (int d = 0; d < 3; ++d)
  {
    at[d] += steps * (to[d] - from[d]) / order;
  }
  return at;
}

void AddEdges(std::vector<Lattice>& nodes, const std::vector<Edge>& edges, int order)
{
  for (const auto& [a, b] : edges)
  {
    const Lattice from = nodes[a];
    const Lattice to = nodes[b];
    for (int i = 1; i < order; ++i)
    {
      nodes.push_back(Along(from, to, order, i));
    }
  }
}

void Append(std::vector<Lattice>& nodes, std::vector<Lattice> inner, const Lattice& shift)
{
  for (Lattice& node : inner)
  {
    std::ranges::transform(node, shift, node.begin(), std::plus());
    nodes.push_back(node);
  }
}

void AddFace(std::vector<Lattice>& nodes, const std::array<int, 4>& corners, int order)
{
  const bool triangle = corners[3] < 0;
  const Lattice origin = nodes[corners[0]];
  const Lattice first = nodes[corners[1]];
  const Lattice second = nodes[triangle ? corners[2] : corners[3]];
  for (const Lattice& inner : PlaneOrder(triangle, order - (triangle ? 3 : 2)))
  {
    const Lattice base = Along(origin, first, order, inner[0] + 1);
    const Lattice across = Along(origin, second, order, inner[1] + 1);
    Lattice node{};
    for (int d = 0; d < 3; ++d)
    {
      node[d] = base[d] + across[d] - origin[d];
    }
    nodes.push_back(node);
  }
}

/// The inside of a prism: triangle by triangle node, along the line both ends first.
void AddPrismInterior(std::vector<Lattice>& nodes, int order)
{
  for (const Lattice& at : PlaneOrder(true, order - 3))
  {
    nodes.push_back({ at[0] + 1, at[1] + 1, 1 });
    nodes.push_back({ at[0] + 1, at[1] + 1, order - 1 });
    for (int k = 2; k < order - 1; ++k)
    {
      nodes.push_back({ at[0] + 1, at[1] + 1, k });
    }
  }
}
} // namespace

const ElementType* FindType(int number)
{
  static const std::map<int, ElementType> types = MakeTypes();
  const auto found = types.find(number);
  return found == types.end() ? nullptr : &found->second;
}

std::string Describe(int number)
{
  const ElementType* type = FindType(number);
  if (type == nullptr || type->dimension < 2)
  {
    return "elements of type " + std::to_string(number);
  }
  const char* plural = type->dimension == 2 ? (type->corners == 3 ? "triangles" : "quadrilaterals")
    : type->shape == Shape::Tetrahedron     ? "tetrahedra"
    : type->shape == Shape::Hexahedron      ? "hexahedra"
    : type->shape == Shape::Prism           ? "prisms"
                                            : "pyramids";
  return std::string(plural) + " of order " + std::to_string(type->order) + " with " +
    std::to_string(type->nodes) + " nodes (type " + std::to_string(number) + ")";
}

std::vector<Lattice> PlaneOrder(bool triangle, int order)
{
  if (order <= 0)
  {
    return order < 0 ? std::vector<Lattice>() : std::vector<Lattice>{ { 0, 0, 0 } };
  }
  std::vector<Lattice> nodes{ { 0, 0, 0 }, { order, 0, 0 } };
  std::vector<Edge> edges{ { 0, 1 }, { 1, 2 } };
  if (triangle)
  {
    nodes.push_back({ 0, order, 0 });
    edges.push_back({ 2, 0 });
  }
  else
  {
    nodes.push_back({ order, order, 0 });
    nodes.push_back({ 0, order, 0 });
    edges.insert(edges.end(), { { 2, 3 }, { 3, 0 } });
  }
  AddEdges(nodes, edges, order);
  Append(nodes, PlaneOrder(triangle, order - (triangle ? 3 : 2)), { 1, 1, 0 });
  return nodes;
}

std::vector<Lattice> NodeOrder(Shape shape, int order)
{
  if (order <= 0)
  {
    return order < 0 ? std::vector<Lattice>() : std::vector<Lattice>{ { 0, 0, 0 } };
  }
  const SolidLattice& solid = SolidOf(shape);
  std::vector<Lattice> nodes;
  for (const Lattice& vertex : solid.vertices)
  {
    nodes.push_back({ vertex[0] * order, vertex[1] * order, vertex[2] * order });
  }
  AddEdges(nodes, solid.edges, order);
  for (const ElementFace& face : solid.faces)
  {
    AddFace(nodes, face.corners, order);
  }
  if (shape == Shape::Prism)
  {
    AddPrismInterior(nodes, order);
  }
  else
  {
    Append(nodes, NodeOrder(shape, order - solid.shrink), { 1, 1, 1 });
  }
  return nodes;
}

const std::vector<ElementFace>& FacesOf(Shape shape)
{
  return SolidOf(shape).faces;
}

const std::vector<ElementFace>& SidesOf(bool triangle)
{
  static const std::vector<ElementFace> ofTriangle{ { { 0, 1, -1, -1 }, 2 },
    { { 1, 2, -1, -1 }, 3 }, { { 2, 0, -1, -1 }, 4 } };
  static const std::vector<ElementFace> ofSquare{ { { 0, 1, -1, -1 }, 2 }, { { 1, 2, -1, -1 }, 1 },
    { { 2, 3, -1, -1 }, 3 }, { { 3, 0, -1, -1 }, 0 } };
  return triangle ? ofTriangle : ofSquare;
}
} // namespace pixelexact::gmsh
