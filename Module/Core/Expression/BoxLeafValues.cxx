// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxLeaves.h"

#include "Core/Element/HessianFunction.h"
#include "Core/Element/JacobianAlgebra.h"
#include "Core/Expression/ModelValue.h"
#include "Core/Shape/Shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

// Computes leaves over a box from enclosures of their polynomials.
namespace pixelexact
{
namespace
{
/// The place of a third derivative, for any order of the directions.
std::size_t ThirdAt(std::size_t a, std::size_t b, std::size_t c)
{
  // 111, 112, 113, 122, 123, 133, 222, 223, 233, 333
  const std::size_t ones = (a == 0) + (b == 0) + (c == 0);
  const std::size_t threes = (a == 2) + (b == 2) + (c == 2);
  constexpr std::array<std::size_t, 4> kFirst{ 6, 3, 1, 0 };
  return kFirst[ones] + threes;
}

template <class Visit>
void ForEachTriple(const Visit& visit)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t b = a; b < 3; ++b)
    {
      for (std::size_t c = b; c < 3; ++c)
      {
        visit(a, b, c);
      }
    }
  }
}

/// The unit of a field's modes. Modes that are all zero have no exponent; their unit is 1.
double UnitOf(const ScaledModes& modes)
{
  const double unit = std::ldexp(1.0, modes.exponent);
  return unit > 0.0 ? unit : 1.0;
}

/// A scalar times a power of two.
template <class T>
T Scaled(const T& value, double factor)
{
  return std::isfinite(factor) && factor > 0.0 ? value * T(factor) : T::Unknown();
}
} // namespace

/// Derivatives of a component of a field, in the units of the modes.
template <class T>
struct BoxLeaves::FieldDerivatives
{
  std::array<T, 3> slopes;     ///< by x
  std::array<T, 6> curvatures; ///< by x
  std::array<T, 6> secondsByXi;
  std::array<T, 9> turned;                     ///< of slope a by xi_j, at 3 a + j
  std::array<std::array<T, 6>, 3> turnedTwice; ///< of slope a by xi_j and xi_k
};

/// Holds intermediate results that several leaves share, in the units of the modes.
template <class T>
struct BoxLeaves::Products
{
  std::array<T, 9> jacobian;
  T determinant;
  T overDeterminant;
  std::array<T, 9> inverse;              ///< d xi_j / d y_a at 3 j + a
  std::array<std::array<T, 6>, 3> bends; ///< second derivatives of the map by xi
  std::array<std::span<const T>, 3> thirdsOfMap;
  std::vector<FieldDerivatives<T>> fields; ///< in the order of ForEachDifferentiated
};

template <class T>
BoxLeaves::Products<T> BoxLeaves::ProductsOf(std::span<const T> p) const
{
  Products<T> products;
  if (!NeedsJacobian)
  {
    return products;
  }
  std::array<T, 9>& J = products.jacobian;
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::copy_n(p.begin() + OfMap[c].slope, 3, J.begin() + static_cast<std::ptrdiff_t>(3 * c));
  }
  products.determinant = Determinant<T>(J);
  products.overDeterminant = Reciprocal(products.determinant);
  for (std::size_t j = 0; j < 3; ++j)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      products.inverse[3 * j + a] = Cofactor<T>(J, a, j) * products.overDeterminant;
    }
  }
  // The polynomials of second and third derivatives follow the others, in the same order as here.
  std::span<const T> rest = p.subspan(Ingredients.size() + (NeedsXi ? 3 : 0));
  std::array<T, 4> factors;
  const auto take = [&rest](std::size_t count)
  {
    const std::span<const T> taken = rest.first(count);
    rest = rest.subspan(count);
    return taken;
  };
  T overH3;
  T overH23;
  const Shape shape = Map.space.shape;
  // The kernels compute second derivatives by another method and differ by at most these errors.
  const auto secondsByXi = [&]([[maybe_unused]] double error)
  {
    auto seconds = HessianFunction::SecondsByXi<T>(
      shape, take(6).template first<6>(), factors[0], factors[1], overH3, overH23);
    if constexpr (std::is_same_v<T, BoxValue>)
    {
      std::ranges::for_each(seconds, [error](T& second) { second.error = error; });
    }
    return seconds;
  };
  if (NeedsSeconds)
  {
    std::ranges::copy(take(4), factors.begin());
    overH3 = Reciprocal(factors[3]);
    overH23 = shape == Shape::Tetrahedron ? overH3 * Reciprocal(factors[2]) : overH3;
    std::ranges::generate(products.bends, [&] { return secondsByXi(OfBends); });
  }
  std::vector<std::array<T, 6>> seconds;
  std::vector<std::span<const T>> thirds;
  ForEachDifferentiated(
    [&](const NeededField& /*field*/, int /*component*/, const Places& places) {
      seconds.push_back(places.hasSeconds ? secondsByXi(places.secondsError) : std::array<T, 6>());
    });
  for (std::size_t c = 0; c < 3 && NeedsThirds; ++c)
  {
    products.thirdsOfMap[c] = take(kThirds);
  }
  ForEachDifferentiated([&](const NeededField& /*field*/, int /*component*/, const Places& places)
    { thirds.push_back(places.hasThirds ? take(kThirds) : std::span<const T>()); });
  std::size_t k = 0;
  ForEachDifferentiated(
    [&](const NeededField& /*field*/, int /*component*/, const Places& places)
    {
      products.fields.push_back(DerivativesOf(products,
        p.subspan(static_cast<std::size_t>(places.slope), 3), seconds[k], thirds[k], places));
      ++k;
    });
  return products;
}

/// With derivatives u by xi and U by x, Phi the map, K = J^-1: from u_j = U_m Phi_m,j follow
///
///   U_a = u_j K_ja,   U_a,k = bent_jk K_ja,   bent_jk = u_jk - U_m Phi_m,jk,   U_ab = U_a,k K_kb,
///   U_a,kl = B_jkl K_ja,   B_jkl = u_jkl - U_m Phi_m,jkl - U_m,l Phi_m,jk - U_m,k Phi_m,jl.
template <class T>
BoxLeaves::FieldDerivatives<T> BoxLeaves::DerivativesOf(const Products<T>& products,
  std::span<const T> slopes, const std::array<T, 6>& seconds, std::span<const T> thirds,
  const Places& places)
{
  const auto K = [&products](std::size_t j, std::size_t a) -> const T&
  { return products.inverse[3 * j + a]; };
  // sum of v_j K_ja.
  const auto byX = [&K](const T& v0, const T& v1, const T& v2, std::size_t a)
  { return v0 * K(0, a) + v1 * K(1, a) + v2 * K(2, a); };
  FieldDerivatives<T> result;
  for (std::size_t a = 0; a < 3; ++a)
  {
    // Uses the kernels' order of operations, so that the bound of their rounding holds.
    result.slopes[a] = byX(slopes[0], slopes[1], slopes[2], a);
  }
  result.secondsByXi = seconds;
  if (!places.hasTurned && !places.hasCurvatures)
  {
    return result;
  }
  std::array<T, 6> bent = seconds;
  for (std::size_t k = 0; k < 6; ++k)
  {
    for (std::size_t m = 0; m < 3; ++m)
    {
      bent[k] = bent[k] - result.slopes[m] * products.bends[m][k];
    }
  }
  std::array<T, 9>& turned = result.turned;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      turned[3 * a + k] = byX(bent[kPairAt[0][k]], bent[kPairAt[1][k]], bent[kPairAt[2][k]], a);
    }
  }
  for (std::size_t a = 0; a < 3 && places.hasCurvatures; ++a)
  {
    for (std::size_t b = a; b < 3; ++b)
    {
      result.curvatures[kPairAt[a][b]] =
        byX(turned[3 * a], turned[3 * a + 1], turned[3 * a + 2], b);
    }
  }
  for (std::size_t k = 0; k < 3 && places.hasThirds; ++k)
  {
    for (std::size_t l = k; l < 3; ++l)
    {
      std::array<T, 3> B;
      for (std::size_t j = 0; j < 3; ++j)
      {
        B[j] = thirds[ThirdAt(j, k, l)];
        for (std::size_t m = 0; m < 3; ++m)
        {
          const std::array<T, 6>& bend = products.bends[m];
          B[j] = B[j] - result.slopes[m] * products.thirdsOfMap[m][ThirdAt(j, k, l)] -
            (turned[3 * m + l] * bend[kPairAt[j][k]] + turned[3 * m + k] * bend[kPairAt[j][l]]);
        }
      }
      for (std::size_t a = 0; a < 3; ++a)
      {
        result.turnedTwice[a][kPairAt[k][l]] = byX(B[0], B[1], B[2], a);
      }
    }
  }
  return result;
}

template <class T>
void BoxLeaves::Evaluate(
  std::span<const T> polynomials, std::span<T> leaves, std::array<T, 9>* jacobian) const
{
  const Products<T> products = ProductsOf(polynomials);
  std::ranges::transform(Leaves, leaves.begin(),
    [&](const Graph::Node& leaf) { return LeafOf(leaf, polynomials, products); });
  if (jacobian != nullptr)
  {
    const double unit = UnitOfMap();
    std::ranges::transform(
      products.jacobian, jacobian->begin(), [unit](const T& one) { return Scaled(one, unit); });
  }
}

template <class T>
T BoxLeaves::LeafOf(
  const Graph::Node& leaf, std::span<const T> p, const Products<T>& products) const
{
  const std::span<const T> J = products.jacobian;
  const double unit = UnitOfMap();
  const auto at = [&](int place) -> const T& { return p[static_cast<std::size_t>(place)]; };
  const auto a = static_cast<std::size_t>(leaf.a);
  switch (leaf.operation)
  {
    case Operation::Constant:
      return std::isnan(leaf.constant) ? T::Unknown() : T(leaf.constant);
    case Operation::Pi:
      return T(KnownInterval{ Interval::Around(std::numbers::pi, 2e-16), false });
    case Operation::Coordinate:
    {
      T coordinate = Scaled(at(OfMap[a].value), unit) +
        T(mesh_.centre[3 * static_cast<std::size_t>(Element) + a]);
      if constexpr (std::is_same_v<T, BoxValue>)
      {
        coordinate.error += OfCoordinates[leaf.a];
      }
      return coordinate;
    }
    case Operation::Reference:
      return p[Ingredients.size() + a];
    case Operation::InverseJacobian:
      return Scaled(products.inverse[3 * a + static_cast<std::size_t>(leaf.b)], 1.0 / unit);
    case Operation::Determinant:
      return Scaled(products.determinant, unit * unit * unit);
    case Operation::ScaledJacobian:
    {
      T lengths(1.0);
      for (std::size_t j = 0; j < 3; ++j)
      {
        lengths = lengths * NormOf(std::array{ J[j], J[3 + j], J[6 + j] });
      }
      return products.determinant * Reciprocal(lengths);
    }
    case Operation::CoordinateByXi:
    {
      const auto b = static_cast<std::size_t>(leaf.b);
      return Scaled(
        leaf.c < 0 ? J[3 * a + b] : products.bends[a][kPairAt[b][static_cast<std::size_t>(leaf.c)]],
        unit);
    }
    case Operation::Value:
      return FieldValue(leaf, p, products);
    case Operation::Slope:
    case Operation::Curvature:
    case Operation::ValueByXi:
    case Operation::SlopeByXi:
      return FieldDerivative(leaf, p, products);
    default:
      return T::Unknown();
  }
}

double BoxLeaves::UnitOfMap() const
{
  return std::ldexp(mesh_.size[static_cast<std::size_t>(Element)], Map.exponent);
}

template <class T>
T BoxLeaves::FieldValue(
  const Graph::Node& leaf, std::span<const T> p, const Products<T>& products) const
{
  const NeededField& needed = Fields[static_cast<std::size_t>(leaf.field)];
  const double unit = UnitOfMap();
  const double ofField = UnitOf(*needed.modes);
  const auto c = static_cast<std::size_t>(leaf.component);
  std::vector<T> values;
  for (const Places& places : needed.components)
  {
    values.push_back(places.value < 0 ? T() : p[static_cast<std::size_t>(places.value)]);
  }
  const std::span<const T> J = products.jacobian;
  switch (needed.field->mapping)
  {
    case Mapping::Covariant:
      return Scaled(Covariant<T>(J, values, c) * products.overDeterminant, ofField / unit);
    case Mapping::Contravariant:
      return Scaled(
        Contravariant<T>(J, values, c) * products.overDeterminant, ofField / (unit * unit));
    case Mapping::Density:
      return Scaled(values[c] * products.overDeterminant, ofField / (unit * unit * unit));
    default:
      return Scaled(values[c], ofField);
  }
}

template <class T>
T BoxLeaves::FieldDerivative(
  const Graph::Node& leaf, std::span<const T> p, const Products<T>& products) const
{
  const NeededField& needed = Fields[static_cast<std::size_t>(leaf.field)];
  if (needed.field->mapping != Mapping::Identity)
  {
    return T::Unknown();
  }
  std::size_t place = 0;
  ForEachDifferentiated([&](const NeededField& field, int component, const Places& /*places*/)
    { place += &field < &needed || (&field == &needed && component < leaf.component) ? 1 : 0; });
  const FieldDerivatives<T>& own = products.fields[place];
  const double unit = UnitOfMap();
  const double ofField = UnitOf(*needed.modes);
  const auto a = static_cast<std::size_t>(leaf.a);
  const auto b = static_cast<std::size_t>(leaf.b);
  const auto c = static_cast<std::size_t>(leaf.c);
  switch (leaf.operation)
  {
    case Operation::Slope:
      return Scaled(own.slopes[a], ofField / unit);
    case Operation::Curvature:
      return Scaled(own.curvatures[kPairAt[a][b]], ofField / (unit * unit));
    case Operation::ValueByXi:
    {
      const Places& places = needed.components[static_cast<std::size_t>(leaf.component)];
      return Scaled(
        leaf.b < 0 ? p[static_cast<std::size_t>(places.slope) + a] : own.secondsByXi[kPairAt[a][b]],
        ofField);
    }
    default:
      return Scaled(
        leaf.c < 0 ? own.turned[3 * a + b] : own.turnedTwice[a][kPairAt[b][c]], ofField / unit);
  }
}
template void BoxLeaves::Evaluate(
  std::span<const BoxValue>, std::span<BoxValue>, std::array<BoxValue, 9>*) const;
template void BoxLeaves::Evaluate(
  std::span<const ModelValue>, std::span<ModelValue>, std::array<ModelValue, 9>*) const;
} // namespace pixelexact
