// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/QuotientModes.h"

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Basis/SimplexNodes.h"
#include "Core/Element/Kernels.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/PointValues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr int kMaxOrder = 16;
constexpr Part kValue[1] = { Part::Value };
/// Largest ratio of the kernels' rounding to that of conversions (see RoundingInKernels).
constexpr double kKernels = 4.0;
/// Covers terms that are omitted because they are far smaller than the bounds.
constexpr double kBoundSlack = 1.0 + 0x1p-10;

/// Nodes of a space, and the modes of what has values there.
struct Interpolation
{
  explicit Interpolation(const Space& space);

  std::vector<Vec3> nodes;
  std::unique_ptr<const ChangeOfBasis> toModes;
  double lebesgue = 0.0; ///< bounds the polynomial that is at most 1 at the nodes
};

/// Lebesgue constants of Gauss-Lobatto nodes on lines, to order 16 (they are 1 to 2.5), and of
/// equispaced ones (1 to 935; L. Trefethen and J. Weideman, J. Approx. Theory 65, 1991).
constexpr double kOfGaussLobatto = 3.0;
double OfEquispaced(int order)
{
  return std::ldexp(1.0, order + 1) / (order + 1);
}

/// The Lebesgue constant of a triangle's or a tetrahedron's nodes, by the magnitudes of all
/// Lagrange functions at Chebyshev points in each eta: with 3/2 as many as the degree, polynomials
/// are at most twice as large between them (H. Ehlich and K. Zeller, Math. Z. 86, 1964).
double LebesgueOf(const Space& space, const ChangeOfBasis& toModes)
{
  const auto count = static_cast<std::size_t>(space.Modes());
  std::vector<double> lagrange(count * count); // of one node after the other
  std::vector<double> unit(count, 0.0);
  for (std::size_t s = 0; s < count; ++s)
  {
    unit[s] = 1.0;
    toModes.Apply(unit, 0.0, std::span(lagrange).subspan(s * count, count));
    unit[s] = 0.0;
  }
  const int along = (3 * space.order[2] + 1) / 2;
  std::vector<double> points;
  points.reserve(static_cast<std::size_t>(along));
  for (int i = 0; i < along; ++i)
  {
    points.push_back(std::cos(std::numbers::pi * (2 * i + 1) / (2.0 * along)));
  }
  const bool isFlat = space.shape == Shape::Prism;
  const std::vector<double> across = isFlat ? std::vector{ 0.0 } : points;
  std::vector<long double> modes(count);
  double most = 0.0;
  for (const double x : points)
  {
    for (const double y : across)
    {
      for (const double z : points)
      {
        const Vec3 xi = TensorToReference(space.shape, { x, y, z });
        EvaluateModes(space, { xi.x, xi.y, xi.z }, modes.data());
        double sum = 0.0;
        for (std::size_t s = 0; s < count; ++s)
        {
          sum += std::fabs(static_cast<double>(std::inner_product(modes.begin(), modes.end(),
            lagrange.begin() + static_cast<std::ptrdiff_t>(s * count), 0.0L)));
        }
        most = std::max(most, sum);
      }
    }
  }
  return (isFlat ? 4.0 : 8.0) * most;
}

Interpolation::Interpolation(const Space& space)
{
  const int last[3] = { space.order[0], space.order[1], space.order[2] };
  const auto nodesOf = [](int order, NodeFamily family)
  {
    const std::vector<long double> exact = LineNodes(order, family);
    return std::vector<double>(exact.begin(), exact.end());
  };
  std::vector<int> places;
  const auto add = [&](const Vec3& node)
  {
    places.push_back(static_cast<int>(places.size()));
    nodes.push_back(node);
  };
  if (space.shape == Shape::Hexahedron)
  {
    std::vector<double> lines[3];
    for (std::size_t d = 0; d < 3; ++d)
    {
      lines[d] = nodesOf(last[d], NodeFamily::GaussLobatto);
    }
    for (const double x : lines[0])
    {
      for (const double y : lines[1])
      {
        for (const double z : lines[2])
        {
          add({ x, y, z });
        }
      }
    }
    toModes = std::make_unique<const ChangeOfBasis>(
      ChangeOfBasis::Hexahedron(space, Family::GaussLobattoLagrange, places));
    lebesgue = kOfGaussLobatto * kOfGaussLobatto * kOfGaussLobatto;
    return;
  }
  const std::vector<double> line = nodesOf(last[2], NodeFamily::Equispaced);
  const auto at = [&line](int i) { return line[static_cast<std::size_t>(i)]; };
  if (space.shape == Shape::Prism)
  {
    const std::vector<double> across = nodesOf(last[1], NodeFamily::Equispaced);
    for (int i = 0; i <= last[2]; ++i)
    {
      for (int k = 0; i + k <= last[2]; ++k)
      {
        for (const double y : across)
        {
          add({ at(i), y, at(k) });
        }
      }
    }
    toModes = std::make_unique<const ChangeOfBasis>(
      ChangeOfBasis::Prism(space, Family::EquispacedLagrange, places));
    Space triangle = space;
    triangle.order[1] = 0;
    places.resize(static_cast<std::size_t>(triangle.Modes()));
    lebesgue = OfEquispaced(last[1]) *
      LebesgueOf(triangle, ChangeOfBasis::Prism(triangle, Family::EquispacedLagrange, places));
    return;
  }
  for (int i = 0; i <= last[2]; ++i)
  {
    for (int j = 0; i + j <= last[2]; ++j)
    {
      for (int k = 0; i + j + k <= last[2]; ++k)
      {
        add({ at(i), at(j), at(k) });
      }
    }
  }
  toModes = std::make_unique<const ChangeOfBasis>(
    ChangeOfBasis::Tetrahedron(space, Family::EquispacedLagrange, places));
  lebesgue = LebesgueOf(space, *toModes);
}

/// Made on first use, kept; safe to call from several threads.
const Interpolation& InterpolationOf(const Space& space)
{
  static std::mutex mutex;
  static std::map<Space, std::unique_ptr<const Interpolation>> kept;
  const std::scoped_lock lock(mutex);
  auto& one = kept[space];
  if (!one)
  {
    one = std::make_unique<const Interpolation>(space);
  }
  return *one;
}

/// The space of products of the map's derivatives, and of these with the field. Derivatives of J's
/// columns have a degree less across one direction each, in simplices in total.
std::optional<Space> SpaceOfProducts(const Space& map, const Space& field, Mapping mapping)
{
  Space space = map;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int m = map.order[d];
    const int lower = map.shape == Shape::Tetrahedron ? 3
      : map.shape == Shape::Prism && d != 1           ? 2
                                                      : 1;
    const int factors = mapping == Mapping::Covariant ? 2 : (mapping == Mapping::Density ? 0 : 1);
    const int order = std::max(3 * m - lower, factors * m + field.order[d]);
    if (order > kMaxOrder)
    {
      return std::nullopt;
    }
    space.order[d] = static_cast<std::uint8_t>(std::max(order, 1));
  }
  if (space.shape != Shape::Hexahedron)
  {
    // Nodes are those of uniform orders.
    const auto most = std::max(space.order[0], space.order[2]);
    space.order[0] = space.order[2] = most;
    space.order[1] =
      space.shape == Shape::Tetrahedron ? std::max(most, space.order[1]) : space.order[1];
    if (space.shape == Shape::Tetrahedron)
    {
      space.order.fill(space.order[1]);
    }
  }
  return space;
}

/// Values of a product and of det J, in the element's units.
struct Products
{
  std::array<double, 3> numerator{};
  double divisor = 0.0;
};

Products ProductsAt(Mapping mapping, const double (&J)[3][3], const double (&F)[3], int components)
{
  const auto cofactor = [&J](std::size_t i, std::size_t j) -> long double
  {
    const auto at = [&](std::size_t k, std::size_t l) -> long double
    { return J[(i + k) % 3][(j + l) % 3]; };
    return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
  };
  Products products;
  long double determinant = 0.0L;
  for (std::size_t k = 0; k < 3; ++k)
  {
    determinant += J[0][k] * cofactor(0, k);
  }
  products.divisor = static_cast<double>(determinant);
  for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
  {
    long double sum = mapping == Mapping::Density ? static_cast<long double>(F[c]) : 0.0L;
    for (std::size_t k = 0; k < 3 && mapping != Mapping::Density; ++k)
    {
      sum +=
        (mapping == Mapping::Covariant ? cofactor(c, k) : static_cast<long double>(J[c][k])) * F[k];
    }
    products.numerator[c] = static_cast<double>(sum);
  }
  return products;
}

double PowerOf(double size, Mapping mapping)
{
  return mapping == Mapping::Covariant  ? 1.0 / size
    : mapping == Mapping::Contravariant ? 1.0 / (size * size)
                                        : 1.0 / (size * size * size);
}

/// The polynomials that have values at the nodes; `most` becomes how far they are off there.
ScaledModes Interpolated(
  const Space& space, const std::vector<std::vector<double>>& values, double& most)
{
  const Interpolation& interpolation = InterpolationOf(space);
  const auto width = static_cast<std::size_t>(space.Modes());
  const KernelSet kernels = KernelsFor(space);
  std::vector<double> all(width * values.size());
  most = 0.0;
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    const std::span<double> modes = std::span(all).subspan(c * width, width);
    interpolation.toModes->Apply(values[c], 0.0, modes);
    const double rounding =
      kKernels * PieceForm::Of(space, 0).ErrorBound(Part::Value, { 0, 0, 0 }, modes.data());
    for (std::size_t first = 0; first < values[c].size(); first += PointValues::kRoom)
    {
      const std::size_t count = std::min(PointValues::kRoom, values[c].size() - first);
      const PointValues found(
        kernels, space, modes.data(), 1, 1.0, std::span(interpolation.nodes).subspan(first, count));
      for (std::size_t i = 0; i < count; ++i)
      {
        most = std::max(most, std::fabs(found.values[0][i] - values[c][first + i]) + rounding);
      }
    }
  }
  return { space, all.data(), static_cast<int>(values.size()) };
}

/// The largest magnitude of a part of some functions, and what kernels make it off.
struct Size
{
  double most = 0.0;
  double error = 0.0;
};

Size SizeOf(const ScaledModes& modes, int components, std::span<const Part> parts)
{
  Size size;
  for (int c = 0; c < components; ++c)
  {
    for (const Part part : parts)
    {
      const BoxPolynomial whole =
        RangeIngredient{ &modes, c, part }.Over(0, { 0, 0, 0 }, { Vec3(-1.0), Vec3(1.0) });
      size.most = std::max(size.most, whole.Hull().Magnitude());
      size.error = std::max(size.error, kKernels * whole.error);
    }
  }
  const double unit = std::ldexp(1.0, modes.exponent);
  return { size.most * unit, size.error * unit + 16.0 * kUnitRoundoff * size.most * unit };
}
} // namespace

std::optional<QuotientModes> MakeQuotientModes(
  const Mesh& mesh, int element, const Field& field, int component, double rounding)
{
  const ScaledModes map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3);
  const int given = field.values.components;
  const ScaledModes reference(
    field.values.SpaceOf(element), field.values.Coefficients(element), given);
  const auto space = map.space.shape == Shape::Pyramid || given > 3
    ? std::nullopt
    : SpaceOfProducts(map.space, reference.space, field.mapping);
  if (!space || !map.finite || !reference.finite)
  {
    return std::nullopt;
  }

  // The errors of sums of three products, each of at most three factors. Terms of second order are
  // covered by kBoundSlack.
  const Size J = SizeOf(map, 3, kDerivatives);
  const Size F = SizeOf(reference, given, kValue);
  const Size cofactors{ 2.0 * J.most * J.most, 4.0 * kBoundSlack * J.most * J.error };
  const double power = PowerOf(mesh.size[static_cast<std::size_t>(element)], field.mapping);
  const double divisorError =
    3.0 * kBoundSlack * (J.most * cofactors.error + cofactors.most * J.error);
  const auto numeratorErrorWith = [&](double errorOfField)
  {
    if (field.mapping == Mapping::Density)
    {
      return power * kBoundSlack * errorOfField;
    }
    const Size& by = field.mapping == Mapping::Covariant ? cofactors : J;
    return power * 3.0 * kBoundSlack * (by.most * errorOfField + by.error * F.most);
  };

  const Interpolation& interpolation = InterpolationOf(*space);
  const KernelSet mapKernels = KernelsFor(map.space);
  const KernelSet fieldKernels = KernelsFor(reference.space);
  const std::size_t nodes = interpolation.nodes.size();
  const int components = component < 0 ? given : 1;
  std::vector<std::vector<double>> values(
    static_cast<std::size_t>(components) + 1, std::vector<double>(nodes));
  for (std::size_t first = 0; first < nodes; first += PointValues::kRoom)
  {
    const std::size_t count = std::min(PointValues::kRoom, nodes - first);
    const std::span<const Vec3> here = std::span(interpolation.nodes).subspan(first, count);
    const PointValues image(
      mapKernels, map.space, map.values.data(), 3, std::ldexp(1.0, map.exponent), here);
    const PointValues value(fieldKernels, reference.space, reference.values.data(), given,
      std::ldexp(1.0, reference.exponent), here);
    for (std::size_t i = 0; i < count; ++i)
    {
      double jacobian[3][3];
      double atNode[3] = {};
      for (std::size_t c = 0; c < 3; ++c)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          jacobian[c][k] = image.slopes[3 * c + k][i];
        }
        atNode[c] = c < static_cast<std::size_t>(given) ? value.values[c][i] : 0.0;
      }
      const Products products = ProductsAt(field.mapping, jacobian, atNode, given);
      for (int c = 0; c < components; ++c)
      {
        values[static_cast<std::size_t>(c)][first + i] =
          power * products.numerator[static_cast<std::size_t>(component < 0 ? c : component)];
      }
      values.back()[first + i] = products.divisor;
    }
  }
  const std::vector<std::vector<double>> divisors{ std::move(values.back()) };
  values.pop_back();
  double numeratorsOff = 0.0;
  double divisorsOff = 0.0;
  QuotientModes quotient{ Interpolated(*space, values, numeratorsOff),
    Interpolated(*space, divisors, divisorsOff) };
  const double grown = kBoundSlack * interpolation.lebesgue;
  quotient.numeratorSlack = grown * (numeratorsOff + numeratorErrorWith(F.error));
  quotient.divisorSlack = grown * (divisorsOff + divisorError);
  quotient.numeratorError = numeratorErrorWith(F.error * (1.0 + rounding / kUnitRoundoff));
  quotient.divisorError = divisorError;
  return quotient.numerators.finite && quotient.divisor.finite &&
      std::isfinite(quotient.numeratorSlack) && std::isfinite(quotient.divisorSlack)
    ? std::optional(std::move(quotient))
    : std::nullopt;
}

double QuotientModes::SlopeFactor() const
{
  const int order = divisor.space.MaxOrder();
  return 4.0 * order * order;
}
} // namespace pixelexact
