// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/PyramidElements.h"

#include "Formats/MFEM/Elements/FuentesFunctions.h"
#include "Formats/MFEM/Elements/LocalOrder.h"
#include "Formats/MFEM/Elements/NodalFunctions.h"
#include "Formats/MFEM/Elements/ScalarElements.h"

#include <algorithm>

namespace pixelexact::mfem
{
namespace
{
LongVec3 ToXi(const LongVec3& unit)
{
  return { 2 * unit[0] - 1, 2 * unit[1] - 1, 2 * unit[2] - 1 };
}

/// The line's points in [0,1].
std::vector<long double> UnitPoints(const CollectionName& name)
{
  auto points = LinePoints(name.closed, name.order + 1);
  std::ranges::transform(points, points.begin(), [](long double z) { return (1 + z) / 2; });
  return points;
}

/// A point of the lattice, barycentric in both triangles that the pyramid's height spans with x and
/// with y.
LongVec3 LatticeNode(const std::vector<long double>& unit, const LatticePoint& point)
{
  const auto [i, j, k] = point;
  const int p = static_cast<int>(unit.size()) - 1;
  const long double besideX = unit[i] + unit[p - i - k];
  const long double besideY = unit[j] + unit[p - j - k];
  const long double weight = (besideX + unit[k]) * (besideY + unit[k]) * unit[p - k];
  if (weight == 0) // the apex, where the line has ends
  {
    return { 0, 0, 1 };
  }
  return { unit[i] * besideY / weight, unit[j] * besideX / weight, unit[k] * unit[p - k] / weight };
}

std::vector<LongVec3> LatticeNodes(const CollectionName& name, const std::vector<long double>& unit)
{
  std::vector<LongVec3> nodes;
  for (const LatticePoint& point : LocalOrder(name, Geometry::Pyramid))
  {
    nodes.push_back(LatticeNode(unit, point));
  }
  return nodes;
}

/// The unknowns of the faces as in Bergot's space, those inside on a cube's lattice drawn together
/// towards the apex.
std::vector<LongVec3> FuentesNodes(const CollectionName& name)
{
  const auto unit = UnitPoints(name);
  const int p = name.order;
  auto nodes = LatticeNodes(name, unit);
  nodes.resize(nodes.size() - std::size_t(p - 1) * (p - 2) * (2 * p - 3) / 6);
  for (int k = 1; k < p; ++k)
  {
    for (int j = 1; j < p; ++j)
    {
      for (int i = 1; i < p; ++i)
      {
        nodes.push_back({ unit[i] * (1 - unit[k]), unit[j] * (1 - unit[k]), unit[k] });
      }
    }
  }
  return nodes;
}

/// Products of Bernstein's polynomials of the height and, of the order that is left, of the two
/// directions in the layer.
SolidFunctions BernsteinFunctions(const CollectionName& name)
{
  return [order = LocalOrder(name, Geometry::Pyramid), p = name.order](
           const LongVec3& xi, long double* values)
  {
    const LongVec3 eta = InTensorSpace(xi);
    std::vector<long double> height(p + 1);
    Bernstein(p).evaluate(eta[2], height.data());
    std::vector<std::vector<long double>> x(p + 1, std::vector<long double>(p + 1));
    auto y = x;
    for (int layer = 0; layer <= p; ++layer)
    {
      const auto line = Bernstein(p - layer);
      line.evaluate(eta[0], x[layer].data());
      line.evaluate(eta[1], y[layer].data());
    }
    std::ranges::transform(order, values,
      [&](const LatticePoint& point)
      { return height[point[2]] * x[point[2]][point[0]] * y[point[2]][point[1]]; });
  };
}

ElementBasis Dense(const CollectionName& name, const Space& space, int count, SolidFunctions made)
{
  ElementBasis basis;
  basis.sources = count;
  basis.parts.push_back(ChangeOfBasis::FromFunctions(space, count,
    [functions = std::move(made), count, factor = name.integral ? kUnitDensity : 1.0L](
      const LongVec3& xi, long double* values)
    {
      functions(xi, values);
      std::for_each(values, values + count, [factor](long double& value) { value *= factor; });
    }));
  return basis;
}

ElementBasis InBergotsSpace(const CollectionName& name)
{
  const Space space = UniformSpace(Shape::Pyramid, name.order);
  if (name.closed == LineBasis::Positive)
  {
    return Dense(name, space, space.Modes(), BernsteinFunctions(name));
  }
  auto nodes = LatticeNodes(name, UnitPoints(name));
  std::ranges::transform(nodes, nodes.begin(), ToXi);
  return Dense(name, space, space.Modes(), Cardinal(space, nodes));
}

Space TensorSpace(int order)
{
  const auto n = static_cast<std::uint8_t>(order);
  return { Shape::Pyramid, Form::Tensor, { n, n, n } };
}

ElementBasis FuentesH1(const CollectionName& name)
{
  const auto nodes = FuentesNodes(name);
  const int count = static_cast<int>(nodes.size());
  const FuentesFunctions functions(name.order);
  std::vector<long double> functionals(std::size_t(count) * count);
  for (int k = 0; k < count; ++k)
  {
    functions.Evaluate(ToXi(nodes[k]), &functionals[std::size_t(k) * count]);
  }
  return Dense(name, TensorSpace(name.order), count,
    Combined([functions](const LongVec3& xi, long double* values)
      { functions.Evaluate(xi, values); },
      count, DualMatrix(count, functionals), count));
}

/// Fuentes's discontinuous space is the whole tensor space; where the line has ends, MFEM draws the
/// heights below Gauss's last point, as no two nodes may meet in the apex.
ElementBasis FuentesL2(const CollectionName& name)
{
  const int n = name.order + 1;
  auto heights = LinePoints(name.closed, n);
  if (heights.back() == 1.0L)
  {
    const long double top = (1 + GaussPoints(n).back()) / 2;
    std::ranges::transform(
      heights, heights.begin(), [top](long double z) { return top * (1 + z) - 1; });
  }
  std::vector<int> source(std::size_t(n) * n * n);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int k = 0; k < n; ++k)
      {
        source[(std::size_t(i) * n + j) * n + k] = i + n * (j + n * k);
      }
    }
  }
  const auto line = LineOf(name.closed, n);
  ElementBasis basis;
  basis.sources = n * n * n;
  basis.parts.push_back(ChangeOfBasis::FromLines(TensorSpace(name.order),
    { Times(name.integral ? kUnitDensity : 1.0L, line), line, Lagrange(heights) }, source));
  return basis;
}
} // namespace

ElementBasis PyramidBasis(const CollectionName& name)
{
  if (name.order == 0)
  {
    return ConstantBasis(name, Shape::Pyramid);
  }
  const bool bergot =
    name.pyramid == PyramidSpace::Bergot || name.closed == LineBasis::Positive || name.legacy;
  if (bergot || (name.continuity == Continuity::H1 && name.order == 1))
  {
    return InBergotsSpace(name);
  }
  return name.continuity == Continuity::H1 ? FuentesH1(name) : FuentesL2(name);
}
} // namespace pixelexact::mfem
