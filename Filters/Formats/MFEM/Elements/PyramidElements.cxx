// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/ElementBases.h"

#include "Core/Basis/BasisFactor.h"
#include "Formats/MFEM/Elements/NodalFunctions.h"
#include "Formats/MFEM/Elements/UnknownOrders.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pixelexact::mfem
{
namespace
{
// The continuous functions of Fuentes, Keith, Demkowicz and Nagaraj (2015) on the pyramid: their
// space, in a basis of its own.

class FuentesFunctions
{
public:
  explicit FuentesFunctions(int order)
    : Order(order)
  {
  }

  [[nodiscard]] int Count() const { return Order * (Order * Order + 3) + 1; }
  void Evaluate(const LongVec3& xi, long double* values) const;

private:
  int Order;
};

using Values = std::vector<long double>;

/// t^i P_i(2 x / t - 1), i <= order; P Legendre's polynomials.
Values ScaledLegendre(int order, long double x, long double t)
{
  Values values(order + 1, 1.0L);
  const long double z = 2 * x - t;
  for (int i = 1; i <= order; ++i)
  {
    const long double before = i > 1 ? values[i - 2] : 0.0L;
    values[i] = ((2 * i - 1) * z * values[i - 1] - (i - 1) * t * t * before) / i;
  }
  return values;
}

/// Edge functions i = 2, 3, ..., order, homogeneous of degree i in the coordinates of the two ends:
/// integrals of Legendre's polynomials. Entries 0 and 1 are empty.
Values EdgeFunctions(int order, long double from, long double to)
{
  const long double t = from + to;
  Values values = ScaledLegendre(order, to, t);
  for (int i = order; i >= 2; --i)
  {
    values[i] = (values[i] - t * t * values[i - 2]) / (4 * i - 2);
  }
  return values;
}

/// The pyramid's tensor coordinates. The apex, where the first two are not defined, is taken as the
/// upper end of the edge from the origin.
LongVec3 InTensorSpace(const LongVec3& xi)
{
  const long double width = (1 - xi[2]) / 2;
  if (width == 0)
  {
    return { -1, -1, 1 };
  }
  return { (1 + xi[0]) / width - 1, (1 + xi[1]) / width - 1, xi[2] };
}

void FuentesFunctions::Evaluate(const LongVec3& xi, long double* values) const
{
  const LongVec3 eta = InTensorSpace(xi);
  const int p = Order;
  // Coordinates that run from zero to one.
  const std::array<long double, 2> xs{ (1 - eta[0]) / 2, (1 + eta[0]) / 2 };
  const std::array<long double, 2> ys{ (1 - eta[1]) / 2, (1 + eta[1]) / 2 };
  const long double z = (1 + eta[2]) / 2;
  const long double low = 1 - z;
  for (int b = 0; b < 2; ++b)
  {
    for (int a = 0; a < 2; ++a)
    {
      const long double vertex = xs[a] * ys[b] * low;
      *values++ = vertex;
      const auto upright = EdgeFunctions(p, vertex, z);
      values = std::copy(upright.begin() + 2, upright.end(), values);
    }
  }
  *values++ = z;
  const auto alongX = EdgeFunctions(p, xs[0], xs[1]);
  const auto alongY = EdgeFunctions(p, ys[0], ys[1]);
  const auto alongZ = EdgeFunctions(p, low, z);
  const auto heights = ScaledLegendre(p, z, 1.0L);
  long double narrowed = low; // low^i
  for (int i = 2; i <= p; ++i)
  {
    narrowed *= low;
    for (int c = 0; c < 2; ++c)
    {
      const long double onX = ys[c] * narrowed * alongX[i];
      const long double onY = xs[c] * narrowed * alongY[i];
      *values++ = onX;
      *values++ = onY;
      for (int j = 1; i + j <= p; ++j)
      {
        *values++ = onX * z * heights[j - 1];
        *values++ = onY * z * heights[j - 1];
      }
    }
    for (int j = 2; j <= p; ++j)
    {
      const long double layer = alongX[i] * alongY[j];
      *values++ = low * layer;
      for (int k = 2; k <= p; ++k)
      {
        *values++ = layer * alongZ[k];
      }
    }
  }
}

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

/// Fuentes's discontinuous space is the whole tensor space. Where the line has end points, MFEM
/// scales the heights to end at Gauss's last point, because two nodes must not coincide in the
/// apex.
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
