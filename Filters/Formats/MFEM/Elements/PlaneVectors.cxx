// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/ElementBases.h"

#include "Formats/MFEM/Elements/NodalFunctions.h"
#include "Formats/MFEM/Elements/VectorSpaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact::mfem
{
namespace
{
/// Factor from a field's components in MFEM's unit element to those in our reference element, whose
/// edges are twice as long: J^-T has the factor 1/2, and so does J / det J with two rows of J.
constexpr long double kToReference = 1 / 2.0L;

bool IsCurl(const CollectionName& name)
{
  return name.continuity == Continuity::HCurl;
}

ChangeOfBasis Nothing(const Space& space, int sources)
{
  return ChangeOfBasis::FromFunctions(space, sources,
    [sources](const LongVec3& /*xi*/, long double* values) { std::fill_n(values, sources, 0.0L); });
}

/// A direction along an edge, or normal to it on its right.
LongVec3 DirectionOn(bool tangential, const LongVec3& along)
{
  return tangential ? along : LongVec3{ along[1], -along[0], 0 };
}

std::vector<VectorUnknown> TriangleUnknowns(const CollectionName& name)
{
  const bool tangential = IsCurl(name);
  const int n = tangential ? name.order : name.order + 1; // on an edge
  const auto open = UnitPoints(LineBasis::GaussLegendre, n);
  const auto inside = UnitPoints(LineBasis::GaussLegendre, n - 1);
  const std::array<LongVec3, 3> corners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } };
  std::vector<VectorUnknown> unknowns;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const LongVec3& a = corners[k];
    const LongVec3& b = corners[(k + 1) % 3];
    const LongVec3 along{ b[0] - a[0], b[1] - a[1], 0 };
    for (const long double u : open)
    {
      unknowns.push_back(
        { { a[0] + u * along[0], a[1] + u * along[1], 0 }, DirectionOn(tangential, along) });
    }
  }
  const int last = static_cast<int>(inside.size()) - 1;
  for (int j = 0; j <= last; ++j)
  {
    for (int i = 0; i + j <= last; ++i)
    {
      const long double sum = inside[i] + inside[j] + inside[last - i - j];
      const LongVec3 node{ inside[i] / sum, inside[j] / sum, 0 };
      // The normals are those of the first and the last edge.
      unknowns.push_back({ node, DirectionOn(tangential, { 1, 0, 0 }) });
      unknowns.push_back({ node, tangential ? LongVec3{ 0, 1, 0 } : LongVec3{ -1, 0, 0 } });
    }
  }
  return unknowns;
}

/// One unknown of a square: its factors along x and y, and its sign.
struct PlaneProduct
{
  int component;
  std::array<int, 2> place;
  int sign;
};

/// The sign of a normal: MFEM turns normals left of or below the middle; of an odd line of unknowns
/// in the middle it turns one half.
int NormalSign(int order, int component, const std::array<int, 2>& place)
{
  const int along = place[static_cast<std::size_t>(component)];
  const int across = place[static_cast<std::size_t>(1 - component)];
  const int half = order / 2;
  const bool isMiddle = order % 2 == 1 && along == half + 1;
  const bool isTurned = component == 0 ? across > half : across <= half;
  return along <= half || (isMiddle && isTurned) ? -1 : 1;
}

std::vector<PlaneProduct> SquareProducts(const CollectionName& name)
{
  const bool tangential = IsCurl(name);
  const int p = name.order;
  const int n = tangential ? p : p + 1; // unknowns on an edge; as many intervals between lines
  std::vector<PlaneProduct> products;
  for (int edge = 0; edge < 4; ++edge)
  {
    const bool isHorizontal = edge % 2 == 0;
    const int component = isHorizontal == tangential ? 0 : 1;
    const bool back = edge > 1;                      // runs against its axis
    const int line = edge == 1 || edge == 2 ? n : 0; // which of the parallel ones
    const bool isTurned = tangential ? back : line == 0;
    for (int i = 0; i < n; ++i)
    {
      const int at = back ? n - 1 - i : i;
      products.push_back({ component,
        isHorizontal ? std::array{ at, line } : std::array{ line, at }, isTurned ? -1 : 1 });
    }
  }
  for (int component = 0; component < 2; ++component)
  {
    // Open points along one axis, closed points without their ends along the other.
    const bool openAlongX = (component == 0) == tangential;
    for (int j = openAlongX ? 1 : 0; j < n; ++j)
    {
      for (int i = openAlongX ? 0 : 1; i < n; ++i)
      {
        products.push_back(
          { component, { i, j }, tangential ? 1 : NormalSign(p, component, { i, j }) });
      }
    }
  }
  return products;
}

LineFunctions SquareLine(const CollectionName& name, bool open)
{
  const int n = IsCurl(name) ? name.order : name.order + 1;
  if (!open)
  {
    return LineOf(name.closed, n + 1);
  }
  return name.open == LineBasis::IntegratedGaussLobatto ? IntegratedOf(name.closed, n)
                                                        : LineOf(name.open, n);
}

ChangeOfBasis SquarePart(const CollectionName& name, const Space& space, int component,
  const std::vector<PlaneProduct>& products)
{
  const bool openAlongX = (component == 0) == IsCurl(name);
  const std::array<LineFunctions, 2> lines{ SquareLine(name, openAlongX),
    SquareLine(name, !openAlongX) };
  return ChangeOfBasis::FromFunctions(space, static_cast<int>(products.size()),
    [&](const LongVec3& xi, long double* out)
    {
      std::array<std::vector<long double>, 2> at;
      for (std::size_t axis = 0; axis < 2; ++axis)
      {
        at[axis].resize(lines[axis].count);
        lines[axis].evaluate(xi[axis], at[axis].data());
      }
      std::ranges::transform(products, out,
        [&](const PlaneProduct& product)
        {
          return product.component != component
            ? 0.0L
            : product.sign * kToReference * at[0][product.place[0]] * at[1][product.place[1]];
        });
    });
}

/// The component along x (axis 0) or y of the functions on the triangle that are dual to the
/// unknowns; functions of (xi1, xi3).
SolidFunctions InPlane(
  Continuity kind, int order, const std::vector<VectorUnknown>& unknowns, int axis)
{
  const PlaneSpace space = TriangleVectors(kind, order);
  const auto n = static_cast<std::size_t>(space.count);
  std::vector<std::array<long double, 2>> values(n);
  std::vector<long double> functionals(n * n);
  for (std::size_t k = 0; k < n; ++k)
  {
    const auto& [node, direction] = unknowns[k];
    space.evaluate(node[0], node[1], values.data());
    for (std::size_t m = 0; m < n; ++m)
    {
      functionals[k * n + m] = values[m][0] * direction[0] + values[m][1] * direction[1];
    }
  }
  const auto component = [space, axis](const LongVec3& xi, long double* out)
  {
    std::vector<std::array<long double, 2>> at(space.count);
    space.evaluate((1 + xi[0]) / 2, (1 + xi[2]) / 2, at.data());
    std::ranges::transform(at, out, [axis](const auto& value) { return value[axis]; });
  };
  return Combined(component, space.count, DualMatrix(space.count, functionals), space.count);
}

/// Tolerance for nodes of different faces that coincide except for rounding.
constexpr long double kSameNode = 1e-12L;

/// Unknowns that are products of unknowns in the triangle and points along the line.
struct Products
{
  std::vector<VectorUnknown> triangle;
  std::vector<long double> points; ///< in [0,1]
  std::vector<int> source;         ///< the unknown for each of the triangle's, and each point
  std::vector<long double> factor; ///< by point: scale factor of upright directions
};

bool IsSame(const VectorUnknown& a, const VectorUnknown& b)
{
  const auto near = [](long double x, long double y) { return std::fabs(x - y) < kSameNode; };
  return near(a.node[0], b.node[0]) && near(a.node[1], b.node[1]) &&
    near(a.direction[0], b.direction[0]) && near(a.direction[1], b.direction[1]);
}

Products SplitByDirection(
  const std::vector<VectorUnknown>& unknowns, bool upright, std::vector<long double> points)
{
  Products products;
  products.factor.assign(points.size(), 1.0L);
  for (std::size_t u = 0; u < unknowns.size(); ++u)
  {
    const VectorUnknown& unknown = unknowns[u];
    if ((unknown.direction[2] != 0) != upright)
    {
      continue;
    }
    const auto place = std::ranges::min_element(
      points, {}, [&](long double z) { return std::fabs(z - unknown.node[2]); });
    const auto j = static_cast<std::size_t>(place - points.begin());
    const auto known = std::ranges::find_if(
      products.triangle, [&unknown](const VectorUnknown& other) { return IsSame(unknown, other); });
    const auto t = static_cast<std::size_t>(known - products.triangle.begin());
    if (known == products.triangle.end())
    {
      products.triangle.push_back(unknown);
      products.source.resize(products.triangle.size() * points.size());
    }
    products.source[t * points.size() + j] = static_cast<int>(u);
    if (upright)
    {
      products.factor[j] = 1 / unknown.direction[2];
    }
  }
  products.points = std::move(points);
  return products;
}

/// The line's functions of xi2, which runs against MFEM's z.
LineFunctions AlongHeight(const Products& products, long double weight)
{
  auto points = products.points;
  std::ranges::transform(points, points.begin(), [](long double z) { return 2 * z - 1; });
  const int count = static_cast<int>(points.size());
  return { count,
    [line = Lagrange(points), factor = products.factor, weight](long double xi2, long double* out)
    {
      line.evaluate(-xi2, out);
      std::transform(factor.begin(), factor.end(), out, out,
        [weight](long double f, long double value) { return weight * f * value; });
    } };
}

SolidFunctions Upright(int order, const Products& products)
{
  std::vector<LongVec3> nodes;
  for (const auto& [node, direction] : products.triangle)
  {
    nodes.push_back({ 2 * node[0] - 1, 0, 2 * node[1] - 1 });
  }
  return Cardinal(TriangleSpace(order), nodes);
}
} // namespace

ElementBasis TriangleVectorBasis(const CollectionName& name)
{
  const auto unknowns = TriangleUnknowns(name);
  const int count = static_cast<int>(unknowns.size());
  const Space space = TriangleSpace(IsCurl(name) ? name.order : name.order + 1);
  ElementBasis basis;
  basis.sources = count;
  const auto part = [&](int axis)
  {
    return ChangeOfBasis::FromFunctions(space, count,
      [functions = InPlane(name.continuity, name.order, unknowns, axis), count](
        const LongVec3& xi, long double* values)
      {
        functions(xi, values);
        std::for_each(values, values + count, [](long double& value) { value *= kToReference; });
      });
  };
  // y is along xi3; the component across is zero.
  basis.parts.push_back(part(0));
  basis.parts.push_back(Nothing(space, count));
  basis.parts.push_back(part(1));
  return basis;
}

ElementBasis SquareVectorBasis(const CollectionName& name)
{
  const auto products = SquareProducts(name);
  const auto n = static_cast<std::uint8_t>(IsCurl(name) ? name.order : name.order + 1);
  const Space space{ Shape::Hexahedron, Form::Collapsed, { n, n, 0 } };
  ElementBasis basis;
  basis.sources = static_cast<int>(products.size());
  basis.parts.push_back(SquarePart(name, space, 0, products));
  basis.parts.push_back(SquarePart(name, space, 1, products));
  basis.parts.push_back(Nothing(space, basis.sources));
  return basis;
}

ElementBasis PrismVectors(const CollectionName& name, const std::vector<VectorUnknown>& unknowns)
{
  const bool curl = name.continuity == Continuity::HCurl;
  const int p = name.order;
  const auto open = UnitPoints(LineBasis::GaussLegendre, curl ? p : p + 1);
  const auto closed = UnitPoints(LineBasis::GaussLobatto, curl ? p + 1 : p + 2);
  const Products lying = SplitByDirection(unknowns, false, curl ? closed : open);
  const Products upright = SplitByDirection(unknowns, true, curl ? open : closed);
  const Space space = UniformSpace(Shape::Prism, curl ? p : p + 1);
  // From MFEM's unit prism to ours: x along xi1, z against xi2, y along xi3.
  const long double weight = curl ? 1 / 2.0L : 1 / 4.0L;
  ElementBasis basis;
  basis.sources = static_cast<int>(unknowns.size());
  for (int d = 0; d < 3; ++d)
  {
    const Products& products = d == 1 ? upright : lying;
    const SolidFunctions triangle =
      d == 1 ? Upright(p, products) : InPlane(name.continuity, p, products.triangle, d / 2);
    basis.parts.push_back(ChangeOfBasis::FromTriangleAndLine(
      space, static_cast<int>(products.triangle.size()),
      [&triangle](long double xi1, long double xi3, long double* values) {
        triangle({ xi1, 0, xi3 }, values);
      },
      AlongHeight(products, d == 1 ? -weight : weight), products.source));
  }
  return basis;
}
} // namespace pixelexact::mfem
