// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Expression/BoxExpression.h"

#include "Core/Element/HessianFunction.h"
#include "Core/Element/JacobianAlgebra.h"
#include "Core/Element/LaneBuffer.h"
#include "Core/Math/Rounding.h"
#include "Core/Shape/Shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
// Places in the list of HessianFunction::Polynomials.
constexpr std::size_t kSecondsOfMap = 12;
constexpr std::size_t kSecondsOfField = 30;
constexpr std::size_t kFactors4 = 36;

constexpr std::size_t kThirds = 10;
/// Places of second derivatives, and of third ones by the first two directions, in ascending order.
constexpr std::array<std::array<std::size_t, 3>, 3> kPairAt{ { { 0, 1, 2 }, { 1, 3, 4 },
  { 2, 4, 5 } } };

/// Whatever the order of the directions.
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

constexpr Box3 kPiece{ Vec3(-1.0), Vec3(1.0) };

bool IsOfFields(const Graph::Node& leaf)
{
  return leaf.operation == Operation::Value || leaf.operation == Operation::Slope ||
    leaf.operation == Operation::Curvature || leaf.operation == Operation::Third;
}

/// xi_direction over a part of a piece: as a function of each eta it is of degree 1.
BoxPolynomial ReferenceOver(
  Shape shape, int direction, int level, const PieceForm::Piece& piece, const Box3& within)
{
  const double pieces = 1 << level;
  BoxPolynomial xi{ { 1, 1, 1 }, {}, 0x1p-50 };
  for (int corner = 0; corner < 8; ++corner)
  {
    Vec3 eta;
    for (int d = 0; d < 3; ++d)
    {
      const double middle = (2.0 * piece[static_cast<std::size_t>(d)] + 1.0) / pieces - 1.0;
      const bool upper = (corner >> (2 - d) & 1) != 0;
      eta[d] = middle + (upper ? within.upper : within.lower)[d] / pieces;
    }
    xi.b.push_back(TensorToReference(shape, eta)[direction]);
  }
  return xi;
}

/// A scalar times a power of two.
BoxValue Scaled(const BoxValue& value, double factor)
{
  return std::isfinite(factor) && factor > 0.0 ? value * BoxValue(factor) : BoxValue::Unknown();
}

/// Bounds the rounding of a polynomial as the kernels evaluate it: they make the same sums as the
/// conversion, but for the order of the factors (accuracy.md).
double KernelError(const RangeIngredient& ingredient)
{
  return 4.0 *
    PieceForm::Of(ingredient.modes->space, 0).ErrorBound(ingredient.part, {}, ingredient.Modes());
}

/// The same of second derivatives by xi of some components, by Markov's inequality for each mode:
/// of degree n it is 4 n^2 times as steep as it is large, at most (D. Wilhelmsen, J. Approx. Theory
/// 11, 1974; the shapes are more than 1 wide). Modes of pyramids are no polynomials in xi.
double SecondsError(const ScaledModes& modes, int first, int count)
{
  constexpr double kSafety = 16.0;
  if (modes.space.shape == Shape::Pyramid)
  {
    return kInfinity;
  }
  const double n = modes.space.MaxOrder();
  double error = 0.0;
  for (int c = first; c < first + count; ++c)
  {
    error = std::max(error, KernelError({ &modes, c, Part::Value }));
  }
  return kSafety * (4.0 * n * n) * (4.0 * n * n) * error;
}

int HighestOrder(std::span<const Field* const> fields, int field, int element)
{
  int order = 0;
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    if (field < 0 || f == static_cast<std::size_t>(field))
    {
      order = std::max(order, fields[f]->values.SpaceOf(element).MaxOrder());
    }
  }
  return order;
}

/// Unbounded where the scalar may be NaN.
AffineForm FormOfDefined(const BoxValue& value)
{
  AffineForm form = value.form;
  if (value.known.mayBeNaN)
  {
    form.e = Interval::Everything();
  }
  return form;
}

/// Second derivatives by xi: J^T F'' J + sum of dF / dx_m Phi_m''. Where that jumps, it is no
/// second derivative.
std::optional<std::array<AffineForm, 6>> SecondsByXi(const JacobianValues& map,
  const std::array<const BoxValue*, 3>& slopes, const std::array<const BoxValue*, 6>& seconds)
{
  const auto mayJump = [](const BoxValue* one) { return one->mayJump; };
  if (std::ranges::any_of(slopes, mayJump) || std::ranges::any_of(seconds, mayJump))
  {
    return std::nullopt;
  }
  std::array<AffineForm, 6> byXi;
  for (std::size_t j = 0; j < 3; ++j)
  {
    for (std::size_t k = j; k < 3; ++k)
    {
      BoxValue sum(0.0);
      for (std::size_t a = 0; a < 3; ++a)
      {
        BoxValue row(0.0);
        for (std::size_t b = 0; b < 3; ++b)
        {
          row = row + *seconds[kPairAt[a][b]] * map.first[3 * b + k];
        }
        sum = sum + row * map.first[3 * a + j] + *slopes[a] * map.second[a][kPairAt[j][k]];
      }
      byXi[kPairAt[j][k]] = FormOfDefined(sum);
      if (!byXi[kPairAt[j][k]].e.IsFinite())
      {
        return std::nullopt;
      }
    }
  }
  return byXi;
}

/// Euclidean norm.
BoxValue NormOf(std::span<const BoxValue> values)
{
  BoxValue sum(0.0);
  for (const BoxValue& value : values)
  {
    sum = sum + Square(value);
  }
  return Sqrt(sum);
}
} // namespace

BoxLeaves::BoxLeaves(std::span<const Graph::Node> leaves, std::span<const Field* const> fields,
  std::span<const std::int64_t> numbers, const Mesh& mesh, int element)
  : Leaves(leaves.begin(), leaves.end())
  , TheMesh(mesh)
  , Element(element)
  , Map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3)
{
  for (const Field* field : fields)
  {
    NeededField& needed = Fields.emplace_back();
    needed.field = field;
    needed.components.resize(static_cast<std::size_t>(field->values.components));
  }
  for (Graph::Node& leaf : Leaves)
  {
    switch (leaf.operation)
    {
      // Numbers of the element become constants.
      case Operation::ElementNumber:
        leaf = { .constant = static_cast<double>(
                   numbers.empty() ? element : numbers[static_cast<std::size_t>(element)]) };
        break;
      case Operation::Order:
        leaf = { .constant = static_cast<double>(HighestOrder(fields, leaf.field, element)) };
        break;
      default:
        Need(leaf);
    }
  }
  Finite = Map.finite || Ingredients.empty();
  for (const NeededField& needed : Fields)
  {
    Finite = Finite && (!needed.modes || needed.modes->finite);
  }
  if (Finite)
  {
    TheLevel = LevelFor(Ingredients);
  }
}

void BoxLeaves::Need(const Graph::Node& leaf)
{
  switch (leaf.operation)
  {
    case Operation::Reference:
      NeedsXi = true;
      return;
    case Operation::Coordinate:
      Choose(Map, leaf.a, false, OfMap[static_cast<std::size_t>(leaf.a)]);
      return;
    case Operation::InverseJacobian:
    case Operation::Determinant:
    case Operation::ScaledJacobian:
      NeedJacobian();
      return;
    default:
      break;
  }
  if (!IsOfFields(leaf))
  {
    return;
  }
  NeededField& needed = Fields[static_cast<std::size_t>(leaf.field)];
  const Expansion& values = needed.field->values;
  if (!needed.modes)
  {
    needed.modes = std::make_unique<const ScaledModes>(
      values.SpaceOf(Element), values.Coefficients(Element), values.components);
  }
  const bool isMapped = needed.field->mapping != Mapping::Identity;
  const bool isSlope = leaf.operation != Operation::Value;
  if (isMapped || isSlope)
  {
    NeedJacobian();
  }
  const bool isThird = leaf.operation == Operation::Third;
  const bool isSecond = isThird || leaf.operation == Operation::Curvature;
  NeedsSeconds = NeedsSeconds || isSecond;
  NeedsThirds = NeedsThirds || isThird;
  for (int c = 0; c < values.components; ++c)
  {
    if (isMapped || c == leaf.component)
    {
      Places& places = needed.components[static_cast<std::size_t>(c)];
      Choose(*needed.modes, c, false, places);
      if (isSlope && !isMapped)
      {
        Choose(*needed.modes, c, true, places);
        places.hasSeconds = places.hasSeconds || isSecond;
        places.hasThirds = places.hasThirds || isThird;
      }
    }
  }
}

void BoxLeaves::NeedJacobian()
{
  for (int c = 0; c < 3; ++c)
  {
    Choose(Map, c, true, OfMap[static_cast<std::size_t>(c)]);
  }
  NeedsJacobian = true;
}

/// Adds what is not in the list yet.
void BoxLeaves::Choose(const ScaledModes& modes, int component, bool slopes, Places& places)
{
  int& place = slopes ? places.slope : places.value;
  if (place >= 0)
  {
    return;
  }
  place = static_cast<int>(Ingredients.size());
  if (slopes)
  {
    AddDerivatives(modes, component, 1, Ingredients);
  }
  else
  {
    Ingredients.push_back({ &modes, component, Part::Value });
  }
}

void BoxLeaves::NeedJet(const Vec3& coordinateErrors, bool withSeconds)
{
  NeedJacobian();
  NeedsSeconds = NeedsSeconds || withSeconds;
  OfCoordinates = coordinateErrors;
  if (!Map.finite || !Finite)
  {
    Finite = false;
    return;
  }
  TheLevel = LevelFor(Ingredients);
  for (const RangeIngredient& ingredient : Ingredients)
  {
    OfKernels.push_back(KernelError(ingredient));
  }
  const std::size_t xi = NeedsXi ? 3 : 0;
  OfKernels.resize(Ingredients.size() + xi);
  OfBends = SecondsError(Map, 0, 3);
  for (NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      Places& places = needed.components[c];
      places.secondsError =
        places.hasSeconds ? SecondsError(*needed.modes, static_cast<int>(c), 1) : 0.0;
    }
  }
}

std::vector<BoxPolynomial> BoxLeaves::Polynomials(
  int level, const PieceForm::Piece& piece, const Box3& within) const
{
  std::vector<BoxPolynomial> list;
  for (const RangeIngredient& ingredient : Ingredients)
  {
    list.push_back(ingredient.Over(level, piece, within));
  }
  const Shape shape = Map.space.shape;
  for (int d = 0; d < 3 && NeedsXi; ++d)
  {
    list.push_back(ReferenceOver(shape, d, level, piece, within));
  }
  if (!NeedsSeconds)
  {
    return list;
  }
  const auto add = [&](std::vector<BoxPolynomial>& all, std::size_t first, std::size_t count)
  {
    for (std::size_t k = first; k < first + count; ++k)
    {
      list.push_back(std::move(all[k]));
      RestrictTo(within, list.back());
    }
  };
  std::vector<BoxPolynomial> ofMap = HessianFunction::Polynomials(Map, Map, 0, level, piece);
  add(ofMap, kFactors4, 4);
  add(ofMap, kSecondsOfMap, 18);
  for (const NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      if (needed.components[c].hasSeconds)
      {
        std::vector<BoxPolynomial> all =
          HessianFunction::Polynomials(Map, *needed.modes, static_cast<int>(c), level, piece);
        add(all, kSecondsOfField, 6);
      }
    }
  }
  const auto addThirds = [&](const ScaledModes& modes, int component)
  {
    std::vector<BoxPolynomial> thirds = HessianFunction::Thirds(modes, component, level, piece);
    add(thirds, 0, kThirds);
  };
  for (int c = 0; c < 3 && NeedsThirds; ++c)
  {
    addThirds(Map, c);
  }
  for (const NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      if (needed.components[c].hasThirds)
      {
        addThirds(*needed.modes, static_cast<int>(c));
      }
    }
  }
  return list;
}

/// Derivatives of a component of a field by x, in the order of the operations' numbers.
struct BoxLeaves::WorldDerivatives
{
  std::array<BoxValue, 3> slopes;
  std::array<BoxValue, 6> seconds;
  std::array<BoxValue, kThirds> thirds;
};

/// What the leaves are made of besides the polynomials themselves, in the units of the modes.
struct BoxLeaves::Products
{
  std::array<BoxValue, 9> jacobian;
  BoxValue determinant;
  BoxValue overDeterminant;
  std::array<BoxValue, 9> inverse;              ///< d xi_j / d y_a at 3 j + a
  std::array<std::array<BoxValue, 6>, 3> bends; ///< second derivatives of the map by xi
  std::array<std::span<const BoxValue>, 3> thirdsOfMap;
  /// By Places::derivatives.
  std::vector<WorldDerivatives> fields;
};

BoxLeaves::Products BoxLeaves::ProductsOf(std::span<const BoxValue> p) const
{
  Products products;
  if (!NeedsJacobian)
  {
    return products;
  }
  std::array<BoxValue, 9>& J = products.jacobian;
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::copy_n(p.begin() + OfMap[c].slope, 3, J.begin() + static_cast<std::ptrdiff_t>(3 * c));
  }
  products.determinant = Determinant<BoxValue>(J);
  products.overDeterminant = Reciprocal(products.determinant);
  for (std::size_t j = 0; j < 3; ++j)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      products.inverse[3 * j + a] = Cofactor<BoxValue>(J, a, j) * products.overDeterminant;
    }
  }
  // The polynomials of second and third derivatives are behind the others, in the same order as
  // here.
  std::span<const BoxValue> rest = p.subspan(Ingredients.size() + (NeedsXi ? 3 : 0));
  std::array<BoxValue, 4> factors;
  const auto take = [&rest](std::size_t count)
  {
    const std::span<const BoxValue> taken = rest.first(count);
    rest = rest.subspan(count);
    return taken;
  };
  BoxValue overH3;
  BoxValue overH23;
  const Shape shape = Map.space.shape;
  // The kernels compute second derivatives in another way, and are off by these errors.
  const auto secondsByXi = [&](double error)
  {
    auto seconds = HessianFunction::SecondsByXi<BoxValue>(
      shape, take(6).first<6>(), factors[0], factors[1], overH3, overH23);
    std::ranges::for_each(seconds, [error](BoxValue& second) { second.error = error; });
    return seconds;
  };
  if (NeedsSeconds)
  {
    std::ranges::copy(take(4), factors.begin());
    overH3 = Reciprocal(factors[3]);
    overH23 = shape == Shape::Tetrahedron ? overH3 * Reciprocal(factors[2]) : overH3;
    std::ranges::generate(products.bends, [&] { return secondsByXi(OfBends); });
  }
  std::vector<std::array<BoxValue, 6>> seconds;
  std::vector<std::span<const BoxValue>> thirds;
  ForEachDifferentiated(
    [&](const NeededField& /*field*/, int /*component*/, const Places& places)
    {
      seconds.push_back(
        places.hasSeconds ? secondsByXi(places.secondsError) : std::array<BoxValue, 6>());
    });
  for (std::size_t c = 0; c < 3 && NeedsThirds; ++c)
  {
    products.thirdsOfMap[c] = take(kThirds);
  }
  ForEachDifferentiated([&](const NeededField& /*field*/, int /*component*/, const Places& places)
    { thirds.push_back(places.hasThirds ? take(kThirds) : std::span<const BoxValue>()); });
  std::size_t k = 0;
  ForEachDifferentiated(
    [&](const NeededField& /*field*/, int /*component*/, const Places& places)
    {
      products.fields.push_back(InWorld(products,
        p.subspan(static_cast<std::size_t>(places.slope), 3), seconds[k], thirds[k], places));
      ++k;
    });
  return products;
}

template <class Visit>
void BoxLeaves::ForEachDifferentiated(const Visit& visit) const
{
  for (const NeededField& needed : Fields)
  {
    for (std::size_t c = 0; c < needed.components.size(); ++c)
    {
      if (needed.components[c].slope >= 0)
      {
        visit(needed, static_cast<int>(c), needed.components[c]);
      }
    }
  }
}

/// With derivatives u by xi and U by x, Phi the map, K = J^-1, and the chain rule:
///
///   U_a = u_j K_ja,   bent_jk = u_jk - U_m Phi_m,jk,   U_ab = bent_jk K_ja K_kb,
///   B_jkl = u_jkl - U_m Phi_m,jkl - V_ml Phi_m,jk - V_mk Phi_m,jl - V_mj Phi_m,kl,
///   V_mj = U_mn Phi_n,j = bent_ij K_im,   U_abc = B_jkl K_ja K_kb K_lc.
BoxLeaves::WorldDerivatives BoxLeaves::InWorld(const Products& products,
  std::span<const BoxValue> slopes, const std::array<BoxValue, 6>& seconds,
  std::span<const BoxValue> thirds, const Places& places)
{
  const auto K = [&products](std::size_t j, std::size_t a) -> const BoxValue&
  { return products.inverse[3 * j + a]; };
  // sum of v_j K_ja.
  const auto byX = [&K](const BoxValue& v0, const BoxValue& v1, const BoxValue& v2, std::size_t a)
  { return v0 * K(0, a) + v1 * K(1, a) + v2 * K(2, a); };
  WorldDerivatives world;
  for (std::size_t a = 0; a < 3; ++a)
  {
    world.slopes[a] = Covariant<BoxValue>(products.jacobian, slopes, a) * products.overDeterminant;
  }
  if (!places.hasSeconds)
  {
    return world;
  }
  std::array<BoxValue, 6> bent = seconds;
  for (std::size_t k = 0; k < 6; ++k)
  {
    for (std::size_t m = 0; m < 3; ++m)
    {
      bent[k] = bent[k] - world.slopes[m] * products.bends[m][k];
    }
  }
  std::array<BoxValue, 9> V; // [3 m + j]
  for (std::size_t m = 0; m < 3; ++m)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      V[3 * m + j] = byX(bent[kPairAt[0][j]], bent[kPairAt[1][j]], bent[kPairAt[2][j]], m);
    }
  }
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t b = a; b < 3; ++b)
    {
      world.seconds[kPairAt[a][b]] = byX(V[3 * a], V[3 * a + 1], V[3 * a + 2], b);
    }
  }
  if (!places.hasThirds)
  {
    return world;
  }
  std::array<BoxValue, kThirds> B;
  ForEachTriple(
    [&](std::size_t j, std::size_t k, std::size_t l)
    {
      BoxValue& one = B[ThirdAt(j, k, l)];
      one = thirds[ThirdAt(j, k, l)];
      for (std::size_t m = 0; m < 3; ++m)
      {
        const std::array<BoxValue, 6>& bend = products.bends[m];
        one = one - world.slopes[m] * products.thirdsOfMap[m][ThirdAt(j, k, l)] -
          (V[3 * m + l] * bend[kPairAt[j][k]] + V[3 * m + k] * bend[kPairAt[j][l]] +
            V[3 * m + j] * bend[kPairAt[k][l]]);
      }
    });
  std::array<std::array<BoxValue, 6>, 3> first;  // [c][jk]
  std::array<std::array<BoxValue, 6>, 3> second; // [j][bc]
  for (std::size_t c = 0; c < 3; ++c)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      for (std::size_t k = j; k < 3; ++k)
      {
        first[c][kPairAt[j][k]] =
          byX(B[ThirdAt(j, k, 0)], B[ThirdAt(j, k, 1)], B[ThirdAt(j, k, 2)], c);
      }
    }
  }
  for (std::size_t j = 0; j < 3; ++j)
  {
    for (std::size_t b = 0; b < 3; ++b)
    {
      for (std::size_t c = b; c < 3; ++c)
      {
        second[j][kPairAt[b][c]] =
          byX(first[c][kPairAt[j][0]], first[c][kPairAt[j][1]], first[c][kPairAt[j][2]], b);
      }
    }
  }
  ForEachTriple(
    [&](std::size_t a, std::size_t b, std::size_t c)
    {
      const std::size_t bc = kPairAt[b][c];
      world.thirds[ThirdAt(a, b, c)] = byX(second[0][bc], second[1][bc], second[2][bc], a);
    });
  return world;
}

void BoxLeaves::Evaluate(
  std::span<const BoxValue> polynomials, std::span<BoxValue> leaves, JacobianValues* jacobian) const
{
  const Products products = ProductsOf(polynomials);
  std::ranges::transform(Leaves, leaves.begin(),
    [&](const Graph::Node& leaf) { return LeafOf(leaf, polynomials, products); });
  if (jacobian != nullptr)
  {
    const double unit = UnitOfMap();
    const auto inWorld = [unit](const BoxValue& one) { return Scaled(one, unit); };
    std::ranges::transform(products.jacobian, jacobian->first.begin(), inWorld);
    for (std::size_t c = 0; c < 3 && NeedsSeconds; ++c)
    {
      std::ranges::transform(products.bends[c], jacobian->second[c].begin(), inWorld);
    }
  }
}

BoxValue BoxLeaves::LeafOf(
  const Graph::Node& leaf, std::span<const BoxValue> p, const Products& products) const
{
  const std::span<const BoxValue> J = products.jacobian;
  const double unit = UnitOfMap();
  const auto at = [&](int place) -> const BoxValue& { return p[static_cast<std::size_t>(place)]; };
  const auto a = static_cast<std::size_t>(leaf.a);
  switch (leaf.operation)
  {
    case Operation::Constant:
      return std::isnan(leaf.constant) ? BoxValue::Unknown() : BoxValue(leaf.constant);
    case Operation::Pi:
      return BoxValue(KnownInterval{ Interval::Around(std::numbers::pi, 2e-16), false });
    case Operation::Coordinate:
    {
      BoxValue coordinate = Scaled(at(OfMap[a].value), unit) +
        BoxValue(TheMesh.centre[3 * static_cast<std::size_t>(Element) + a]);
      coordinate.error += OfCoordinates[leaf.a];
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
      BoxValue lengths(1.0);
      for (std::size_t j = 0; j < 3; ++j)
      {
        lengths = lengths * NormOf(std::array{ J[j], J[3 + j], J[6 + j] });
      }
      return products.determinant * Reciprocal(lengths);
    }
    case Operation::Value:
      return FieldValue(leaf, p, products);
    case Operation::Slope:
    case Operation::Curvature:
    case Operation::Third:
      return FieldDerivative(leaf, products);
    default:
      return BoxValue::Unknown();
  }
}

double BoxLeaves::UnitOfMap() const
{
  return std::ldexp(TheMesh.size[static_cast<std::size_t>(Element)], Map.exponent);
}

BoxValue BoxLeaves::FieldValue(
  const Graph::Node& leaf, std::span<const BoxValue> p, const Products& products) const
{
  const NeededField& needed = Fields[static_cast<std::size_t>(leaf.field)];
  const double unit = UnitOfMap();
  const double ofField = std::ldexp(1.0, needed.modes->exponent);
  const auto c = static_cast<std::size_t>(leaf.component);
  std::vector<BoxValue> values;
  for (const Places& places : needed.components)
  {
    values.push_back(places.value < 0 ? BoxValue() : p[static_cast<std::size_t>(places.value)]);
  }
  const std::span<const BoxValue> J = products.jacobian;
  switch (needed.field->mapping)
  {
    case Mapping::Covariant:
      return Scaled(Covariant<BoxValue>(J, values, c) * products.overDeterminant, ofField / unit);
    case Mapping::Contravariant:
      return Scaled(
        Contravariant<BoxValue>(J, values, c) * products.overDeterminant, ofField / (unit * unit));
    case Mapping::Density:
      return Scaled(values[c] * products.overDeterminant, ofField / (unit * unit * unit));
    default:
      return Scaled(values[c], ofField);
  }
}

BoxValue BoxLeaves::FieldDerivative(const Graph::Node& leaf, const Products& products) const
{
  const NeededField& needed = Fields[static_cast<std::size_t>(leaf.field)];
  if (needed.field->mapping != Mapping::Identity)
  {
    return BoxValue::Unknown();
  }
  std::size_t place = 0;
  ForEachDifferentiated([&](const NeededField& field, int component, const Places& /*places*/)
    { place += &field < &needed || (&field == &needed && component < leaf.component) ? 1 : 0; });
  const WorldDerivatives& world = products.fields[place];
  const double unit = UnitOfMap();
  const double ofField = std::ldexp(1.0, needed.modes->exponent);
  const auto a = static_cast<std::size_t>(leaf.a);
  const auto b = static_cast<std::size_t>(leaf.b);
  switch (leaf.operation)
  {
    case Operation::Slope:
      return Scaled(world.slopes[a], ofField / unit);
    case Operation::Curvature:
      return Scaled(world.seconds[kPairAt[a][b]], ofField / (unit * unit));
    default:
      return Scaled(world.thirds[ThirdAt(a, b, static_cast<std::size_t>(leaf.c))],
        ofField / (unit * unit * unit));
  }
}

BoxExpression::BoxExpression(std::shared_ptr<const NodeList> list,
  std::span<const Field* const> fields, std::span<const std::int64_t> numbers, const Mesh& mesh,
  int element)
  : List(std::move(list))
  , Leaves(List->leaves, fields, numbers, mesh, element)
{
}

BoxValue BoxExpression::ValueWith(std::span<const BoxValue> polynomials) const
{
  std::vector<BoxValue> leaves(List->leaves.size());
  Leaves.Evaluate(polynomials, leaves);
  std::vector<BoxValue> values;
  List->Compute([&](std::size_t k) { return leaves[k]; }, ApplyToBoxes, values);
  std::vector<BoxValue> outputs;
  std::ranges::transform(
    List->outputs, std::back_inserter(outputs), [&](std::size_t place) { return values[place]; });
  return outputs.size() == 1 ? outputs.front() : NormOf(outputs);
}

Interval BoxExpression::Enclose(std::span<const BoxPolynomial> polynomials) const
{
  std::vector<BoxValue> values;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    values.emplace_back(polynomial.Affine(), KnownInterval{ polynomial.Hull(), false });
  }
  return ValueWith(values).Range();
}

Interval BoxExpression::AtCorner(std::span<const BoxPolynomial> polynomials, unsigned corner) const
{
  std::vector<BoxValue> values;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    values.emplace_back(KnownInterval{ polynomial.AtCorner(corner), false });
  }
  return ValueWith(values).Range();
}

BoxJet::BoxJet(std::shared_ptr<const NodeList> list, const CompiledGraph& code,
  std::span<const Field* const> fields, std::span<const std::int64_t> numbers, const Mesh& mesh,
  int element, const Vec3& coordinateErrors)
  : List(std::move(list))
  , Code(code)
  , Leaves(List->leaves, fields, numbers, mesh, element)
  , TheMesh(mesh)
  , Element(element)
{
  Leaves.NeedJet(coordinateErrors, HasSeconds());
}

std::vector<BoxPolynomial> BoxJet::Polynomials(int level, const PieceForm::Piece& piece) const
{
  return Leaves.Polynomials(level, piece, kPiece);
}

JetBounds BoxJet::Over(std::span<const AffineForm> forms, std::span<const Interval> hulls) const
{
  std::vector<BoxValue> polynomials;
  for (std::size_t k = 0; k < forms.size(); ++k)
  {
    BoxValue& value = polynomials.emplace_back(forms[k], KnownInterval{ hulls[k], false });
    value.error = k < Leaves.Errors().size() ? Leaves.Errors()[k] : 0.0;
  }
  std::vector<BoxValue> leaves(List->leaves.size());
  JacobianValues map;
  Leaves.Evaluate(polynomials, leaves, &map);
  std::vector<BoxValue> nodes;
  List->Compute([&](std::size_t k) { return leaves[k]; }, ApplyToBoxes, nodes);
  const auto output = [&](std::size_t k) -> const BoxValue& { return nodes[List->outputs[k]]; };
  JetBounds bounds;
  bounds.values = output(0).Range();
  bounds.isContinuous = !output(0).mayJump;
  bounds.valueError = output(0).error;
  for (std::size_t j = 0; j < 3; ++j)
  {
    BoxValue slope(0.0);
    for (std::size_t d = 0; d < 3; ++d)
    {
      slope = slope + map.first[3 * d + j] * output(1 + d);
    }
    bounds.slopes[j] = FormOfDefined(slope);
    bounds.slopeError = std::max(bounds.slopeError, slope.error);
  }
  if (HasSeconds())
  {
    bounds.seconds = SecondsByXi(map, { &output(1), &output(2), &output(3) },
      { &output(4), &output(5), &output(6), &output(7), &output(8), &output(9) });
  }
  return bounds;
}

void BoxJet::Evaluate(
  std::span<const Vec3> xi, std::span<double> values, std::span<Vec3> gradients) const
{
  const LaneBuffer lanes(xi);
  const auto stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(xi.size())));
  std::vector<double> storage(4 * stride);
  const std::array<double*, 4> out{ storage.data(), storage.data() + stride,
    storage.data() + 2 * stride, storage.data() + 3 * stride };
  Code.Evaluate(TheMesh, Element, { lanes.View() }, out);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    values[i] = out[0][i];
    gradients[i] = { out[1][i], out[2][i], out[3][i] };
  }
}
} // namespace pixelexact
