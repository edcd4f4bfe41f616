// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Gmsh/ElementType.h"

#include <algorithm>
#include <array>
#include <map>

namespace pixelexact::gmsh
{
namespace
{
/// Types of one kind of element, orders ascending from `order`; 0 stands for no such type.
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
} // namespace pixelexact::gmsh
