// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/VectorElements.h"

#include "Core/Base/Error.h"
#include "Formats/MFEM/NodalFunctions.h"
#include "Formats/MFEM/VectorSpaces.h"
#include "Formats/MFEM/VectorUnknowns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact::mfem
{
namespace
{
/// How a field's components in MFEM's unit element become those in ours: with A the derivative of
/// the unit coordinates by xi, H(curl) multiplies by A^T, H(div) by det A A^-1. A is half a signed
/// permutation, so both are one, times a factor.
class ToReference
{
public:
  ToReference(Continuity kind, Geometry solid)
    : Prism(solid == Geometry::Prism)
    , Factor(kind == Continuity::HCurl ? 1 / 2.0L : 1 / 4.0L)
  {
  }

  /// The unit axis that becomes xi_d.
  [[nodiscard]] int Axis(int d) const { return Prism && d > 0 ? 3 - d : d; }
  [[nodiscard]] long double Weight(int d) const { return Prism && d == 1 ? -Factor : Factor; }

  [[nodiscard]] LongVec3 Unit(const LongVec3& xi) const
  {
    const auto half = [](long double z) { return (1 + z) / 2; };
    return Prism ? LongVec3{ half(xi[0]), half(xi[2]), half(-xi[1]) }
                 : LongVec3{ half(xi[0]), half(xi[1]), half(xi[2]) };
  }

private:
  bool Prism;
  long double Factor;
};

Shape ShapeOf(Geometry solid)
{
  switch (solid)
  {
    case Geometry::Cube:
      return Shape::Hexahedron;
    case Geometry::Prism:
      return Shape::Prism;
    case Geometry::Pyramid:
      return Shape::Pyramid;
    default:
      return Shape::Tetrahedron;
  }
}

/// The functions of `space` that are dual to the unknowns; row m, column j of the result as in
/// DualMatrix.
std::vector<long double> Dual(
  const VectorSpace& space, const std::vector<VectorUnknown>& unknowns)
{
  const auto n = static_cast<std::size_t>(space.count);
  std::vector<long double> functionals(n * n);
  std::vector<LongVec3> values(n);
  for (std::size_t k = 0; k < n; ++k)
  {
    space.evaluate(unknowns[k].node, values.data());
    const LongVec3& direction = unknowns[k].direction;
    for (std::size_t m = 0; m < n; ++m)
    {
      functionals[k * n + m] = values[m][0] * direction[0] + values[m][1] * direction[1] +
        values[m][2] * direction[2];
    }
  }
  return DualMatrix(space.count, functionals);
}

/// Sums of the functions of `space`, as `matrix` says, into `target`.
ElementBasis Dense(const Space& target, const VectorSpace& space,
  const std::vector<long double>& matrix, const ToReference& toReference)
{
  ElementBasis basis;
  basis.sources = space.count;
  for (int d = 0; d < 3; ++d)
  {
    const auto component = [&](const LongVec3& xi, long double* out)
    {
      std::vector<LongVec3> values(space.count);
      space.evaluate(toReference.Unit(xi), values.data());
      for (int m = 0; m < space.count; ++m)
      {
        out[m] = toReference.Weight(d) * values[m][toReference.Axis(d)];
      }
    };
    basis.parts.push_back(ChangeOfBasis::FromFunctions(
      target, space.count, Combined(component, space.count, matrix, space.count)));
  }
  return basis;
}

/// The legacy elements of lowest order take the flux through a triangle for the unknown, the others
/// twice that.
void HalveTriangles(const CollectionName& name, Geometry solid, std::vector<VectorUnknown>& all)
{
  if (!name.legacy || name.continuity != Continuity::HDiv || solid == Geometry::Cube)
  {
    return;
  }
  const std::size_t triangles = solid == Geometry::Prism ? 2 : all.size();
  for (std::size_t i = 0; i < triangles; ++i)
  {
    for (long double& part : all[i].direction)
    {
      part /= 2;
    }
  }
}

ElementBasis OnSimplexOrPrism(const CollectionName& name, Geometry solid)
{
  const VectorSpace space = solid == Geometry::Prism
    ? PrismSpace(name.continuity, name.order)
    : TetrahedronSpace(name.continuity, name.order);
  auto unknowns = VectorUnknowns(name, solid);
  HalveTriangles(name, solid, unknowns);
  const int degree = name.order + (name.continuity == Continuity::HDiv ? 1 : 0);
  return Dense(UniformSpace(ShapeOf(solid), degree), space, Dual(space, unknowns),
    { name.continuity, solid });
}

ElementBasis OnPyramid(const CollectionName& name)
{
  const bool curl = name.continuity == Continuity::HCurl;
  if (name.order != (curl ? 1 : 0))
  {
    throw Unsupported("pyramids of the finite element collection '" + name.text +
      "' are not read beyond the lowest order; project the field to L2 in MFEM "
      "(ProjectGridFunction) and save that.");
  }
  const VectorSpace space = LowestPyramidSpace(name.continuity);
  std::vector<long double> matrix(std::size_t(space.count) * space.count, 0.0L);
  for (int i = 0; i < space.count; ++i)
  {
    const bool triangle = !curl && i > 0;
    matrix[std::size_t(i) * space.count + i] = name.legacy && triangle ? 2.0L : 1.0L;
  }
  return Dense({ Shape::Pyramid, Form::Tensor, { 1, 1, 1 } }, space, matrix,
    { name.continuity, Geometry::Pyramid });
}

/// One unknown of a cube: the functions along the axes whose product it is, and its sign.
struct Product
{
  std::array<int, 3> place;
  int component;
  int sign;
};

Product ProductOf(const std::array<std::array<std::vector<long double>, 3>, 3>& lines,
  const VectorUnknown& unknown)
{
  Product product{};
  while (unknown.direction[product.component] == 0)
  {
    ++product.component;
  }
  product.sign = unknown.direction[product.component] > 0 ? 1 : -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    // The nearest one: the node may have been rounded.
    const auto& line = lines[product.component][axis];
    const auto nearest = std::ranges::min_element(line, {}, [&](long double point)
      { return std::fabs(point - unknown.node[axis]); });
    product.place[axis] = static_cast<int>(nearest - line.begin());
  }
  return product;
}

LineFunctions LagrangeOnUnit(std::vector<long double> points)
{
  std::ranges::transform(points, points.begin(), [](long double x) { return 2 * x - 1; });
  return Lagrange(std::move(points));
}

ElementBasis OnCube(const CollectionName& name)
{
  const auto unknowns = VectorUnknowns(name, Geometry::Cube);
  std::array<std::array<std::vector<long double>, 3>, 3> lines;
  for (int component = 0; component < 3; ++component)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lines[component][axis] = CubeLine(name, component, axis);
    }
  }
  std::vector<Product> products(unknowns.size());
  std::ranges::transform(unknowns, products.begin(),
    [&lines](const VectorUnknown& unknown) { return ProductOf(lines, unknown); });
  const ToReference toReference(name.continuity, Geometry::Cube);
  const int degree = name.order + (name.continuity == Continuity::HDiv ? 1 : 0);
  const Space space = UniformSpace(Shape::Hexahedron, degree);
  const int count = static_cast<int>(products.size());
  ElementBasis basis;
  basis.sources = count;
  for (int d = 0; d < 3; ++d)
  {
    std::array<LineFunctions, 3> functions;
    std::ranges::transform(lines[d], functions.begin(), LagrangeOnUnit);
    const auto values = [&](const LongVec3& xi, long double* out)
    {
      std::array<std::vector<long double>, 3> at;
      for (int axis = 0; axis < 3; ++axis)
      {
        at[axis].resize(functions[axis].count);
        functions[axis].evaluate(xi[axis], at[axis].data());
      }
      std::ranges::transform(products, out,
        [&](const Product& product)
        {
          return product.component != d
            ? 0.0L
            : product.sign * toReference.Weight(d) * at[0][product.place[0]] *
              at[1][product.place[1]] * at[2][product.place[2]];
        });
    };
    basis.parts.push_back(ChangeOfBasis::FromFunctions(space, count, values));
  }
  return basis;
}
} // namespace

ElementBasis VectorBasis(const CollectionName& name, Geometry solid)
{
  switch (solid)
  {
    case Geometry::Cube:
      return OnCube(name);
    case Geometry::Pyramid:
      return OnPyramid(name);
    default:
      return OnSimplexOrPrism(name, solid);
  }
}
} // namespace pixelexact::mfem
