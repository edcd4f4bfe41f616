// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/ElementBases.h"

#include "Formats/MFEM/Elements/NodalFunctions.h"
#include "Formats/MFEM/Elements/UnknownOrders.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace pixelexact::mfem
{
namespace
{
constexpr int kAxes = 3;

long double Density(const CollectionName& name)
{
  if (!name.integral)
  {
    return 1.0L;
  }
  return name.dimension == 2 ? kPlaneUnitDensity : kUnitDensity;
}

LineFunctions Line(const CollectionName& name)
{
  return LineOf(name.closed, name.order + 1);
}

ElementBasis OnePart(ChangeOfBasis part)
{
  ElementBasis basis;
  basis.sources = part.SourceSize();
  basis.parts.push_back(std::move(part));
  return basis;
}

ElementBasis Cube(const CollectionName& name, const std::vector<LatticePoint>& order)
{
  const int n = name.order + 1;
  std::vector<int> source(order.size());
  for (std::size_t unknown = 0; unknown < order.size(); ++unknown)
  {
    const auto [i, j, k] = order[unknown];
    source[(std::size_t(i) * n + j) * n + k] = static_cast<int>(unknown);
  }
  const auto line = Line(name);
  return OnePart(ChangeOfBasis::FromLines(UniformSpace(Shape::Hexahedron, name.order),
    { Times(Density(name), line), line, line }, source));
}

/// x, y, z in [0,1] of a lattice point of a simplex: barycentric coordinates in proportion to the
/// line's points.
LongVec3 SimplexNode(const std::vector<long double>& line, const LatticePoint& point, int axes)
{
  const auto at = [&line](int i) { return (1 + line[i]) / 2; };
  int rest = static_cast<int>(line.size()) - 1;
  LongVec3 node{};
  for (int d = 0; d < axes; ++d)
  {
    rest -= point[d];
    node[d] = at(point[d]);
  }
  long double sum = at(rest);
  for (const long double part : node)
  {
    sum += part;
  }
  for (long double& part : node)
  {
    part /= sum;
  }
  return node;
}

/// Bernstein's polynomial of a simplex in the barycentric coordinates that go with the lattice
/// point; the last one is the origin's.
long double BernsteinValue(int order, const LatticePoint& point, const LongVec3& x, int axes)
{
  long double value = 1.0L;
  long double origin = 1.0L;
  int rest = order;
  const auto multiply = [&value](long double coordinate, int exponent, int total)
  {
    for (int i = 1; i <= exponent; ++i)
    {
      value *= coordinate * (total - exponent + i) / i;
    }
  };
  for (int d = 0; d < axes; ++d)
  {
    multiply(x[d], point[d], rest);
    rest -= point[d];
    origin -= x[d];
  }
  multiply(origin, rest, rest);
  return value;
}

LongVec3 ToUnit(const LongVec3& xi)
{
  return { (1 + xi[0]) / 2, (1 + xi[1]) / 2, (1 + xi[2]) / 2 };
}

SolidFunctions TetrahedronFunctions(
  const CollectionName& name, const Space& space, const std::vector<LatticePoint>& order)
{
  if (name.closed == LineBasis::Positive)
  {
    return [order, p = name.order](const LongVec3& xi, long double* values)
    {
      const LongVec3 x = ToUnit(xi);
      std::ranges::transform(order, values,
        [&](const LatticePoint& point) { return BernsteinValue(p, point, x, kAxes); });
    };
  }
  const auto line = LinePoints(name.closed, name.order + 1);
  std::vector<LongVec3> nodes(order.size());
  std::ranges::transform(order, nodes.begin(),
    [&line](const LatticePoint& point)
    {
      const LongVec3 x = SimplexNode(line, point, kAxes);
      return LongVec3{ 2 * x[0] - 1, 2 * x[1] - 1, 2 * x[2] - 1 };
    });
  return Cardinal(space, nodes);
}

ElementBasis Tetrahedron(const CollectionName& name, const std::vector<LatticePoint>& order)
{
  const Space space = UniformSpace(Shape::Tetrahedron, name.order);
  const int count = static_cast<int>(order.size());
  return OnePart(ChangeOfBasis::FromFunctions(space, count,
    [functions = TetrahedronFunctions(name, space, order), count, factor = Density(name)](
      const LongVec3& xi, long double* values)
    {
      functions(xi, values);
      std::for_each(values, values + count, [factor](long double& value) { value *= factor; });
    }));
}

/// A triangle's place by the two counts, y slowest.
std::vector<LatticePoint> TriangleLattice(int p)
{
  std::vector<LatticePoint> points;
  for (int j = 0; j <= p; ++j)
  {
    for (int i = 0; i + j <= p; ++i)
    {
      points.push_back({ i, j, 0 });
    }
  }
  return points;
}

using TriangleFunctions = std::function<void(long double, long double, long double*)>;

/// The functions on the prism's triangle, x along xi1 and y along xi3.
TriangleFunctions OnTriangle(
  const CollectionName& name, const Space& space, const std::vector<LatticePoint>& lattice)
{
  if (name.closed == LineBasis::Positive)
  {
    return [lattice, p = name.order](long double xi1, long double xi3, long double* values)
    {
      const LongVec3 x{ (1 + xi1) / 2, (1 + xi3) / 2, 0 };
      std::ranges::transform(
        lattice, values, [&](const LatticePoint& point) { return BernsteinValue(p, point, x, 2); });
    };
  }
  const auto line = LinePoints(name.closed, name.order + 1);
  std::vector<LongVec3> nodes(lattice.size());
  std::ranges::transform(lattice, nodes.begin(),
    [&line](const LatticePoint& point)
    {
      const LongVec3 x = SimplexNode(line, point, 2);
      return LongVec3{ 2 * x[0] - 1, 0, 2 * x[1] - 1 };
    });
  const Space triangle{ Shape::Prism, Form::Collapsed, { space.order[0], 0, space.order[2] } };
  return
    [cardinal = Cardinal(triangle, nodes)](long double xi1, long double xi3, long double* values) {
      cardinal({ xi1, 0, xi3 }, values);
    };
}

ElementBasis Prism(const CollectionName& name, const std::vector<LatticePoint>& order)
{
  const Space space = UniformSpace(Shape::Prism, name.order);
  const auto lattice = TriangleLattice(name.order);
  std::vector<int> source(order.size());
  for (std::size_t unknown = 0; unknown < order.size(); ++unknown)
  {
    const auto [i, j, k] = order[unknown];
    const auto triangle = std::ranges::find(lattice, LatticePoint{ i, j, 0 }) - lattice.begin();
    source[std::size_t(triangle) * (name.order + 1) + k] = static_cast<int>(unknown);
  }
  // MFEM's z runs against xi2.
  return OnePart(ChangeOfBasis::FromTriangleAndLine(space, static_cast<int>(lattice.size()),
    OnTriangle(name, space, lattice), Times(Density(name), Mirrored(Line(name))), source));
}
/// Across the slab on a plane element.
LineFunctions Constant(long double value)
{
  return { 1, [value](long double /*z*/, long double* values) { *values = value; } };
}

ElementBasis Square(const CollectionName& name, const std::vector<LatticePoint>& order)
{
  const int n = name.order + 1;
  std::vector<int> source(order.size());
  for (std::size_t unknown = 0; unknown < order.size(); ++unknown)
  {
    const auto& point = order[unknown];
    source[std::size_t(point[0]) * n + point[1]] = static_cast<int>(unknown);
  }
  const auto line = Line(name);
  const auto p = static_cast<std::uint8_t>(name.order);
  return OnePart(ChangeOfBasis::FromLines({ Shape::Hexahedron, Form::Collapsed, { p, p, 0 } },
    { line, line, Constant(Density(name)) }, source));
}

ElementBasis Triangle(const CollectionName& name, const std::vector<LatticePoint>& order)
{
  const auto p = static_cast<std::uint8_t>(name.order);
  const Space space{ Shape::Prism, Form::Collapsed, { p, 0, p } };
  std::vector<int> source(order.size());
  std::iota(source.begin(), source.end(), 0);
  return OnePart(ChangeOfBasis::FromTriangleAndLine(space, static_cast<int>(order.size()),
    OnTriangle(name, space, order), Constant(Density(name)), source));
}
} // namespace

ElementBasis ConstantBasis(const CollectionName& name, Shape shape)
{
  return OnePart(ChangeOfBasis::FromFunctions(UniformSpace(shape, 0), 1,
    [value = Density(name)](const LongVec3& /*xi*/, long double* values) { *values = value; }));
}

ElementBasis ScalarBasis(const CollectionName& name, Geometry solid)
{
  const auto order = LocalOrder(name, solid);
  switch (solid)
  {
    case Geometry::Cube:
      return Cube(name, order);
    case Geometry::Prism:
      return Prism(name, order);
    case Geometry::Square:
      return Square(name, order);
    case Geometry::Triangle:
      return Triangle(name, order);
    default:
      return Tetrahedron(name, order);
  }
}
} // namespace pixelexact::mfem
