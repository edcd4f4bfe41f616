// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/MFEM/Elements/PrismVectors.h"

#include "Formats/MFEM/Elements/NodalFunctions.h"
#include "Formats/MFEM/Elements/PlaneVectors.h"
#include "Formats/MFEM/Elements/VectorSpaces.h"
#include "Formats/MFEM/Elements/VectorUnknownBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact::mfem
{
namespace
{
/// Nodes of different faces that are one have been rounded differently.
constexpr long double kSameNode = 1e-12L;

/// Unknowns that are products: of those in the triangle and of the points along the line.
struct Products
{
  std::vector<VectorUnknown> triangle;
  std::vector<long double> points; ///< in [0,1]
  std::vector<int> source;         ///< the unknown for each of the triangle's, and each point
  std::vector<long double> factor; ///< by point: what makes upright directions into units
};

bool IsSame(const VectorUnknown& a, const VectorUnknown& b)
{
  const auto near = [](long double x, long double y) { return std::fabs(x - y) < kSameNode; };
  return near(a.node[0], b.node[0]) && near(a.node[1], b.node[1]) &&
    near(a.direction[0], b.direction[0]) && near(a.direction[1], b.direction[1]);
}

Products Split(
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

/// The line's functions, of xi2, against which MFEM's z runs.
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

ElementBasis PrismVectors(const CollectionName& name, const std::vector<VectorUnknown>& unknowns)
{
  const bool curl = name.continuity == Continuity::HCurl;
  const int p = name.order;
  const auto open = UnitPoints(LineBasis::GaussLegendre, curl ? p : p + 1);
  const auto closed = UnitPoints(LineBasis::GaussLobatto, curl ? p + 1 : p + 2);
  const Products lying = Split(unknowns, false, curl ? closed : open);
  const Products upright = Split(unknowns, true, curl ? open : closed);
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
