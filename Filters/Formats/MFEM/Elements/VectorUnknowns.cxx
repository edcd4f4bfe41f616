// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/VectorUnknowns.h"

#include "Formats/MFEM/Elements/VectorUnknownBuilder.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pixelexact::mfem
{
namespace
{
using Corner = LongVec3;

std::vector<VectorUnknown> Tetrahedron(VectorUnknownBuilder builder)
{
  const std::array<Corner, 4> v{ { { 0, 0, 0 }, kX, kY, kZ } };
  builder.Edge(v[0], v[1]);
  builder.Edge(v[0], v[2]);
  builder.Edge(v[0], v[3]);
  builder.Edge(v[1], v[2]);
  builder.Edge(v[1], v[3]);
  builder.Edge(v[2], v[3]);
  builder.Triangle(v[1], v[2], v[3]);
  builder.Triangle(v[0], v[3], v[2]);
  builder.Triangle(v[0], v[1], v[3]);
  builder.Triangle(v[0], v[2], v[1]);
  builder.InsideTetrahedron();
  return builder.Take();
}

std::vector<VectorUnknown> Prism(VectorUnknownBuilder builder)
{
  const std::array<Corner, 6> v{ { { 0, 0, 0 }, kX, kY, kZ, { 1, 0, 1 }, { 0, 1, 1 } } };
  for (int layer : { 0, 3 })
  {
    builder.Edge(v[layer], v[layer + 1]);
    builder.Edge(v[layer + 1], v[layer + 2]);
    builder.Edge(v[layer + 2], v[layer]);
  }
  for (int i = 0; i < 3; ++i)
  {
    builder.Edge(v[i], v[i + 3]);
  }
  builder.Triangle(v[0], v[2], v[1]);
  builder.Triangle(v[3], v[4], v[5]);
  builder.Square(v[0], v[1], v[3]);
  builder.Square(v[1], v[2], v[4]);
  builder.Square(v[2], v[0], v[5]);
  builder.InsidePrism();
  return builder.Take();
}

std::vector<VectorUnknown> Cube(VectorUnknownBuilder builder)
{
  const std::array<Corner, 8> v{ { { 0, 0, 0 }, kX, { 1, 1, 0 }, kY, kZ, { 1, 0, 1 }, { 1, 1, 1 },
    { 0, 1, 1 } } };
  for (int layer : { 0, 4 })
  {
    builder.Edge(v[layer], v[layer + 1]);
    builder.Edge(v[layer + 1], v[layer + 2]);
    builder.Edge(v[layer + 3], v[layer + 2]);
    builder.Edge(v[layer], v[layer + 3]);
  }
  for (int i = 0; i < 4; ++i)
  {
    builder.Edge(v[i], v[i + 4]);
  }
  builder.Square(v[3], v[2], v[0]);
  builder.Square(v[0], v[1], v[4]);
  builder.Square(v[1], v[2], v[5]);
  builder.Square(v[2], v[3], v[6]);
  builder.Square(v[3], v[0], v[7]);
  builder.Square(v[4], v[5], v[7]);
  builder.InsideCube();
  return builder.Take();
}
std::vector<VectorUnknown> Pyramid(VectorUnknownBuilder builder)
{
  const std::array<Corner, 5> v{ { { 0, 0, 0 }, kX, { 1, 1, 0 }, kY, kZ } };
  builder.Edge(v[0], v[1]);
  builder.Edge(v[1], v[2]);
  builder.Edge(v[3], v[2]);
  builder.Edge(v[0], v[3]);
  for (int i = 0; i < 4; ++i)
  {
    builder.Edge(v[i], v[4]);
  }
  builder.Square(v[3], v[2], v[0]);
  for (int i = 0; i < 4; ++i)
  {
    builder.Triangle(v[i], v[(i + 1) % 4], v[4]);
  }
  builder.InsidePyramid();
  return builder.Take();
}
} // namespace

std::vector<VectorUnknown> VectorUnknowns(const CollectionName& name, Geometry solid)
{
  if (solid == Geometry::Cube)
  {
    auto unknowns = Cube({ name.continuity, name.closed, name.open, name.order });
    if (name.legacy && name.continuity == Continuity::HDiv && name.order == 1)
    {
      // The four inside along each axis stand the other way round in "RT1_3D".
      for (std::size_t i = unknowns.size() - 12; i < unknowns.size(); i += 4)
      {
        std::swap(unknowns[i + 1], unknowns[i + 2]);
      }
    }
    return unknowns;
  }
  VectorUnknownBuilder builder(
    name.continuity, LineBasis::GaussLobatto, LineBasis::GaussLegendre, name.order);
  switch (solid)
  {
    case Geometry::Prism:
      return Prism(std::move(builder));
    case Geometry::Pyramid:
      return Pyramid(std::move(builder));
    default:
      return Tetrahedron(std::move(builder));
  }
}

std::vector<long double> CubeLine(const CollectionName& name, int component, int axis)
{
  const bool tangential = name.continuity == Continuity::HCurl;
  const int n = tangential ? name.order : name.order + 1;
  return (component == axis) == tangential ? UnitPoints(name.open, n)
                                           : UnitPoints(name.closed, n + 1);
}
} // namespace pixelexact::mfem
