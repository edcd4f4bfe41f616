// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/NodeOrder.h"

#include <algorithm>

namespace pixelexact::gmsh
{
namespace
{
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
