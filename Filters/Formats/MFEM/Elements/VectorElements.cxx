// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/ElementBases.h"

#include "Formats/MFEM/Elements/NodalFunctions.h"
#include "Formats/MFEM/Elements/VectorSpaces.h"
#include "Formats/MFEM/Elements/VectorUnknowns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace pixelexact::mfem
{
namespace
{
/// Factor from a field's components in MFEM's unit element to those in our reference element, whose
/// edges are twice as long.
long double ToReference(Continuity kind)
{
  return kind == Continuity::HCurl ? 1 / 2.0L : 1 / 4.0L;
}

LongVec3 Unit(const LongVec3& xi)
{
  return { (1 + xi[0]) / 2, (1 + xi[1]) / 2, (1 + xi[2]) / 2 };
}

/// The functions of `space` that are dual to the unknowns; row m, column j of the result as in
/// DualMatrix.
std::vector<long double> Dual(const VectorSpace& space, const std::vector<VectorUnknown>& unknowns)
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
      functionals[k * n + m] =
        values[m][0] * direction[0] + values[m][1] * direction[1] + values[m][2] * direction[2];
    }
  }
  return DualMatrix(space.count, functionals);
}

/// Sums of the functions of `space`, with the coefficients in `matrix`, as a basis of `target`.
ElementBasis Dense(const Space& target, const VectorSpace& space,
  const std::vector<long double>& matrix, long double factor)
{
  ElementBasis basis;
  basis.sources = space.count;
  for (int d = 0; d < 3; ++d)
  {
    const auto component = [&](const LongVec3& xi, long double* out)
    {
      std::vector<LongVec3> values(space.count);
      space.evaluate(Unit(xi), values.data());
      for (int m = 0; m < space.count; ++m)
      {
        out[m] = factor * values[m][d];
      }
    };
    basis.parts.push_back(ChangeOfBasis::FromFunctions(
      target, space.count, Combined(component, space.count, matrix, space.count)));
  }
  return basis;
}

/// The legacy elements of lowest order take the flux through a triangle for the unknown, the others
/// twice that.
void SubdivideTriangles(const CollectionName& name, Geometry solid, std::vector<VectorUnknown>& all)
{
  if (!name.legacy || name.continuity != Continuity::HDiv)
  {
    return;
  }
  const std::size_t first = solid == Geometry::Pyramid ? 1 : 0;
  const std::size_t end = solid == Geometry::Prism ? 2 : all.size();
  for (std::size_t i = first; i < end; ++i)
  {
    for (long double& part : all[i].direction)
    {
      part /= 2;
    }
  }
}

VectorSpace SpaceOn(const CollectionName& name, Geometry solid)
{
  if (solid == Geometry::Tetrahedron)
  {
    return TetrahedronSpace(name.continuity, name.order);
  }
  return name.continuity == Continuity::HCurl ? FuentesCurl(name.order) : FuentesDiv(name.order);
}

ElementBasis ByUnknowns(
  const CollectionName& name, Geometry solid, const std::vector<VectorUnknown>& unknowns)
{
  const VectorSpace space = SpaceOn(name, solid);
  const auto n =
    static_cast<std::uint8_t>(name.order + (name.continuity == Continuity::HDiv ? 1 : 0));
  const Space target = solid == Geometry::Pyramid
    ? Space{ Shape::Pyramid, Form::Tensor, { n, n, n } }
    : UniformSpace(Shape::Tetrahedron, n);
  return Dense(target, space, Dual(space, unknowns), ToReference(name.continuity));
}

/// Points in [0,1] by component and axis.
using Lines = std::array<std::array<std::vector<long double>, 3>, 3>;

/// One unknown of a cube: its factors along the axes, and its sign.
struct Product
{
  std::array<int, 3> place;
  int component;
  int sign;
};

Product ProductOf(const Lines& lines, const VectorUnknown& unknown)
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
    const auto nearest = std::ranges::min_element(
      line, {}, [&](long double point) { return std::fabs(point - unknown.node[axis]); });
    product.place[axis] = static_cast<int>(nearest - line.begin());
  }
  return product;
}

LineFunctions LagrangeOnUnit(std::vector<long double> points)
{
  std::ranges::transform(points, points.begin(), [](long double x) { return 2 * x - 1; });
  return Lagrange(std::move(points));
}

Lines LinesOf(const CollectionName& name)
{
  Lines lines;
  for (int component = 0; component < 3; ++component)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lines[component][axis] = CubeLine(name, component, axis);
    }
  }
  return lines;
}

/// Component d as products of lines, for H(div), where an unknown's sign depends only on its place
/// along d.
ChangeOfBasis ByLines(const Space& space, int d, const std::vector<Product>& products,
  std::array<LineFunctions, 3> lines, long double weight)
{
  const std::array<int, 3> counts{ lines[0].count, lines[1].count, lines[2].count };
  std::vector<int> source(products.size() / 3);
  std::vector<long double> factor(counts[d]);
  for (std::size_t unknown = 0; unknown < products.size(); ++unknown)
  {
    const auto& [place, component, sign] = products[unknown];
    if (component == d)
    {
      source[(std::size_t(place[0]) * counts[1] + place[1]) * counts[2] + place[2]] =
        static_cast<int>(unknown);
      factor[place[d]] = sign * weight;
    }
  }
  lines[d].evaluate = [inner = std::move(lines[d].evaluate), factor](
                        long double z, long double* values)
  {
    inner(z, values);
    std::transform(factor.begin(), factor.end(), values, values, std::multiplies<>());
  };
  return ChangeOfBasis::FromLines(space, lines, source);
}

/// Component d of H(curl), whose signs are no product.
ChangeOfBasis ByProducts(const Space& space, int d, const std::vector<Product>& products,
  std::array<LineFunctions, 3> lines, long double weight)
{
  return ChangeOfBasis::FromFunctions(space, static_cast<int>(products.size()),
    [&](const LongVec3& xi, long double* out)
    {
      std::array<std::vector<long double>, 3> at;
      for (int axis = 0; axis < 3; ++axis)
      {
        at[axis].resize(lines[axis].count);
        lines[axis].evaluate(xi[axis], at[axis].data());
      }
      std::ranges::transform(products, out,
        [&](const Product& product)
        {
          const auto& [place, component, sign] = product;
          return component != d
            ? 0.0L
            : sign * weight * at[0][place[0]] * at[1][place[1]] * at[2][place[2]];
        });
    });
}

ElementBasis OnCube(const CollectionName& name)
{
  const auto unknowns = VectorUnknowns(name, Geometry::Cube);
  const Lines lines = LinesOf(name);
  std::vector<Product> products(unknowns.size());
  std::ranges::transform(unknowns, products.begin(),
    [&lines](const VectorUnknown& unknown) { return ProductOf(lines, unknown); });
  const bool curl = name.continuity == Continuity::HCurl;
  const Space space = UniformSpace(Shape::Hexahedron, curl ? name.order : name.order + 1);
  ElementBasis basis;
  basis.sources = static_cast<int>(products.size());
  for (int d = 0; d < 3; ++d)
  {
    std::array<LineFunctions, 3> functions;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto& line = lines[d][axis];
      const bool integrated = name.open == LineBasis::IntegratedGaussLobatto && (axis == d) == curl;
      functions[axis] = integrated ? IntegratedOf(name.closed, static_cast<int>(line.size()))
                                   : LagrangeOnUnit(line);
    }
    basis.parts.push_back(
      (curl ? ByProducts : ByLines)(space, d, products, functions, ToReference(name.continuity)));
  }
  return basis;
}
} // namespace

ElementBasis VectorBasis(const CollectionName& name, Geometry solid)
{
  if (solid == Geometry::Cube)
  {
    return OnCube(name);
  }
  if (solid == Geometry::Triangle)
  {
    return TriangleVectorBasis(name);
  }
  if (solid == Geometry::Square)
  {
    return SquareVectorBasis(name);
  }
  auto unknowns = VectorUnknowns(name, solid);
  SubdivideTriangles(name, solid, unknowns);
  return solid == Geometry::Prism ? PrismVectors(name, unknowns)
                                  : ByUnknowns(name, solid, unknowns);
}
} // namespace pixelexact::mfem
