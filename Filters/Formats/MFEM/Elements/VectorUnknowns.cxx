// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/VectorUnknowns.h"

#include "Formats/MFEM/Elements/NodalFunctions.h"
#include "Formats/MFEM/Elements/VectorSpaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact::mfem
{
namespace
{
LongVec3 Difference(const LongVec3& a, const LongVec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

LongVec3 Negated(const LongVec3& a)
{
  return { -a[0], -a[1], -a[2] };
}

LongVec3 Moved(
  const LongVec3& a, long double u, const LongVec3& along, long double v, const LongVec3& across)
{
  LongVec3 point{};
  for (int d = 0; d < 3; ++d)
  {
    point[d] = a[d] + u * along[d] + v * across[d];
  }
  return point;
}

LongLine WithoutEnds(const LongLine& line)
{
  return { line.begin() + 1, line.end() - 1 };
}

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

std::vector<long double> UnitPoints(LineBasis basis, int n)
{
  if (n <= 0)
  {
    return {};
  }
  LongLine line = LinePoints(basis, n);
  std::ranges::transform(line, line.begin(), [](long double z) { return (1 + z) / 2; });
  return line;
}

VectorUnknownBuilder::VectorUnknownBuilder(
  Continuity kind, LineBasis closed, LineBasis open, int order)
  : Tangential(kind == Continuity::HCurl)
  , Order(order)
  , Open(UnitPoints(open, Tangential ? order : order + 1))
  , Closed(UnitPoints(closed, Tangential ? order + 1 : order + 2))
  , Between(WithoutEnds(Closed))
  , OnFace(UnitPoints(open, Tangential ? order - 1 : order + 1))
  , InSolid(UnitPoints(open, Tangential ? order - 2 : order))
{
}

void VectorUnknownBuilder::Edge(const LongVec3& a, const LongVec3& b)
{
  if (!Tangential)
  {
    return;
  }
  const LongVec3 along = Difference(b, a);
  for (const long double u : Open)
  {
    Unknowns.push_back({ Moved(a, u, along, 0, along), along });
  }
}

void VectorUnknownBuilder::Triangle(const LongVec3& a, const LongVec3& b, const LongVec3& c)
{
  const LongVec3 along = Difference(b, a);
  const LongVec3 across = Difference(c, a);
  OnTriangle(OnFace, a, along, across,
    Tangential ? std::vector{ along, across } : std::vector{ Cross(along, across) });
}

void VectorUnknownBuilder::Square(const LongVec3& a, const LongVec3& b, const LongVec3& d)
{
  const LongVec3 along = Difference(b, a);
  const LongVec3 across = Difference(d, a);
  if (!Tangential)
  {
    Grid(a, along, Open, across, Open, Cross(along, across));
    return;
  }
  Grid(a, along, Open, across, Between, along);
  Grid(a, along, Between, across, Open, across);
}

void VectorUnknownBuilder::InsideTetrahedron()
{
  const int n = static_cast<int>(InSolid.size());
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j + k < n; ++j)
    {
      for (int i = 0; i + j + k < n; ++i)
      {
        const LongVec3 part{ InSolid[i], InSolid[j], InSolid[k] };
        const long double sum = part[0] + part[1] + part[2] + InSolid[n - 1 - i - j - k];
        const LongVec3 node{ part[0] / sum, part[1] / sum, part[2] / sum };
        for (const LongVec3& axis : { kX, kY, kZ })
        {
          Unknowns.push_back({ node, Tangential ? axis : Negated(axis) });
        }
      }
    }
  }
}

void VectorUnknownBuilder::InsidePrism()
{
  for (const long double z : Tangential ? Between : Open)
  {
    OnTriangle(Tangential ? OnFace : InSolid, { 0, 0, z }, kX, kY,
      Tangential ? std::vector{ kX, kY } : std::vector{ Negated(kY), Negated(kX) });
  }
  for (const long double z : Tangential ? Open : Between)
  {
    if (Tangential)
    {
      InsideClosedTriangle(z);
    }
    else
    {
      OnTriangle(OnFace, { 0, 0, z }, kX, kY, { kZ });
    }
  }
}

void VectorUnknownBuilder::InsideCube()
{
  const std::array axes{ kX, kY, kZ };
  for (int component = 0; component < 3; ++component)
  {
    const auto line = [&](int axis) -> const LongLine&
    { return (axis == component) == Tangential ? Open : Between; };
    for (const long double z : line(2))
    {
      for (const long double y : line(1))
      {
        for (std::size_t i = 0; i < line(0).size(); ++i)
        {
          Unknowns.push_back({ { line(0)[i], y, z }, axes[component] });
          Orient(component);
        }
      }
    }
  }
}

/// Adds the unknowns on a cube's lattice that is contracted towards the apex.
void VectorUnknownBuilder::InsidePyramid()
{
  static const long double half = std::sqrt(0.5L);
  static const std::array tangents{ kX, kY, LongVec3{ -half, -half, 2 * half } };
  static const std::array normals{ LongVec3{ 2 * half, 0, half }, LongVec3{ 0, 2 * half, half },
    kZ };
  for (int component = 0; component < 3; ++component)
  {
    const auto line = [&](int axis) -> const LongLine&
    { return (axis == component) == Tangential ? Open : Between; };
    for (const long double z : line(2))
    {
      for (const long double y : line(1))
      {
        for (const long double x : line(0))
        {
          Unknowns.push_back(
            { { x * (1 - z), y * (1 - z), z }, (Tangential ? tangents : normals)[component] });
        }
      }
    }
  }
}

/// Normals inside of a cube point away from its centre, those on it forwards.
void VectorUnknownBuilder::Orient(int component)
{
  VectorUnknown& unknown = Unknowns.back();
  const auto place = std::ranges::find(Closed, unknown.node[component]) - Closed.begin();
  if (!Tangential && place <= Order / 2)
  {
    unknown.direction = Negated(unknown.direction);
  }
}

void VectorUnknownBuilder::OnTriangle(const LongLine& line, const LongVec3& a,
  const LongVec3& along, const LongVec3& across, const std::vector<LongVec3>& directions)
{
  const int n = static_cast<int>(line.size());
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i + j < n; ++i)
    {
      const long double sum = line[i] + line[j] + line[n - 1 - i - j];
      for (const LongVec3& direction : directions)
      {
        Unknowns.push_back({ Moved(a, line[i] / sum, along, line[j] / sum, across), direction });
      }
    }
  }
}

/// Upright unknowns at the nodes inside of the continuous element's triangle.
void VectorUnknownBuilder::InsideClosedTriangle(long double z)
{
  for (int j = 1; j < Order; ++j)
  {
    for (int i = 1; i + j < Order; ++i)
    {
      const long double sum = Closed[i] + Closed[j] + Closed[Order - i - j];
      Unknowns.push_back({ { Closed[i] / sum, Closed[j] / sum, z }, kZ });
    }
  }
}

void VectorUnknownBuilder::Grid(const LongVec3& a, const LongVec3& along, const LongLine& us,
  const LongVec3& across, const LongLine& vs, const LongVec3& direction)
{
  for (const long double v : vs)
  {
    for (const long double u : us)
    {
      Unknowns.push_back({ Moved(a, u, along, v, across), direction });
    }
  }
}

std::vector<VectorUnknown> VectorUnknowns(const CollectionName& name, Geometry solid)
{
  if (solid == Geometry::Cube)
  {
    auto unknowns = Cube({ name.continuity, name.closed, name.open, name.order });
    if (name.legacy && name.continuity == Continuity::HDiv && name.order == 1)
    {
      // The four interior unknowns along each axis have the reverse order in "RT1_3D".
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
