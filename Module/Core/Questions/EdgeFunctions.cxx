// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeFunctions.h"

#include "Core/Element/FieldFunction.h"
#include "Core/Element/Ranges.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Tree/Regularity.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
using edges::LargestOf;
using edges::SumOf;

namespace
{
/// The largest depth of subdivision of boxes on which the map is not regular, and of those where it
/// is, for functions with few coefficients. Nodes of functions with many cost more, and have a
/// smaller depth.
constexpr int kMaxSubdivisions[2] = { 20, 22 };
constexpr double kFewCoefficients = 216.0;
/// The cost of the map and the component at a point, and of four of their modes, in nanoseconds.
constexpr std::int64_t kCostOfView = 200;
constexpr std::int64_t kCostOfFourModes = 3;
/// The cost of a point whose xi Newton's iteration finds, and of other points, such as those next
/// to folds.
constexpr std::int64_t kCostOfSample = 1500;
constexpr std::int64_t kCostOfHardSample = 250'000;
/// The cost of an expression over two boxes, for each operation and for each coefficient and degree
/// of its polynomials, and at a point.
constexpr std::int64_t kCostOfOperation = 100;
constexpr std::int64_t kCostOfTerm = 2;
constexpr std::int64_t kCostOfPointOperation = 12;
constexpr std::int64_t kViewsOfJet = 50;
/// Limits of subdivisions without cost: the largest depth of boxes, and their cost together.
constexpr int kMaxFree = 8;
constexpr std::int64_t kMaxFreeCost = 50'000'000;
} // namespace

EdgeFunctions::EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element,
  const Field& field, int component, double rounding)
  : EdgeFunctions(
      mesh, bounds, element, ModesOf(mesh, bounds, element, field, component, rounding), rounding)
{
}

EdgeFunctions::EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element)
  : EdgeFunctions(mesh, bounds, element,
      { ScaledModes(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 0), 0, std::nullopt,
        true, nullptr },
      0.0)
{
}

EdgeFunctions::Modes EdgeFunctions::ModesOf(const Mesh& mesh, const ElementBounds& bounds,
  int element, const Field& field, int component, double rounding)
{
  const int count = component < 0 ? field.values.components : 1;
  if (field.function != nullptr)
  {
    const double most = kMaxMiss * mesh.size[static_cast<std::size_t>(element)];
    const Vec3 off(
      most * bounds.uncertainty[0], most * bounds.uncertainty[1], most * bounds.uncertainty[2]);
    const bool isNorm = component < 0 && count > 1;
    auto jet = field.function->JetOnElement(
      mesh, element, isNorm ? FieldFunction::kNorm : std::max(component, 0), off);
    const bool known = jet != nullptr && jet->IsFinite();
    // The map's modes replace those of the component, which does not have any.
    return { ScaledModes(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 1), 1,
      std::nullopt, known, std::move(jet) };
  }
  const Space& space = field.values.SpaceOf(element);
  // Each component of a mapped vector depends on all of them.
  const bool isMapped = field.mapping != Mapping::Identity;
  ScaledModes modes(space,
    field.values.Coefficients(element) +
      static_cast<std::ptrdiff_t>(isMapped ? 0 : std::max(component, 0)) * space.Modes(),
    isMapped ? field.values.components : count);
  const bool finite = modes.finite;
  if (!isMapped || !finite)
  {
    return { std::move(modes), count, std::nullopt, finite, nullptr };
  }
  std::optional<QuotientModes> quotient =
    MakeQuotientModes(mesh, element, field, component, rounding);
  const bool known = quotient.has_value();
  return { known ? quotient->numerators : std::move(modes), count, std::move(quotient), known,
    nullptr };
}

EdgeFunctions::EdgeFunctions(
  const Mesh& mesh, const ElementBounds& bounds, int element, Modes modes, double rounding)
  : Map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3)
  , Component(std::move(modes.component))
  , Divisor(modes.quotient ? std::optional(modes.quotient->divisor) : std::nullopt)
  , Jet(std::move(modes.jet))
  , MapKernels(KernelsFor(Map.space))
  , ComponentKernels(KernelsFor(Component.space))
  , Count(modes.count)
  , Known(modes.known)
  , Centre(mesh.centre[3 * static_cast<std::size_t>(element)],
      mesh.centre[3 * static_cast<std::size_t>(element) + 1],
      mesh.centre[3 * static_cast<std::size_t>(element) + 2])
  , Unit(mesh.size[static_cast<std::size_t>(element)])
  , Unsure{ bounds.uncertainty[0], bounds.uncertainty[1], bounds.uncertainty[2] }
  , Range(Interval::Everything())
{
  if (!Known)
  {
    Error = kInfinity;
    return;
  }
  ChooseLevel();
  if (modes.quotient)
  {
    TakeSlack(*modes.quotient);
  }
  const std::size_t pieces = std::size_t{ 1 } << (3 * Level);
  Kept = std::make_unique<PieceStore<EdgePolynomials>>(Level);
  JetPolynomials = Jet ? std::make_unique<PieceStore<JetBatches>>(Level) : nullptr;
  Costs = std::make_unique<MadeOnDemand<EdgePolynomials::Cost>>(pieces);
  Range = ValuesOver({});
  BoundErrors(rounding);
  if (modes.quotient)
  {
    const QuotientModes& quotient = *modes.quotient;
    // Includes the errors of the kernels and of ValuesAt.
    Error += Count * (quotient.numeratorError + Slack[0]);
    DivisorError = ErrorOf(*Divisor, 1, Part::Value) + quotient.divisorError + DivisorSlack[0];
    for (const Part part : kDerivatives)
    {
      DivisorSlopeError = std::max(DivisorSlopeError, ErrorOf(*Divisor, 1, part));
    }
    SlopeError += Count * Slack[1];
    DivisorSlopeError += DivisorSlack[1];
  }
}

void EdgeFunctions::TakeSlack(const QuotientModes& quotient)
{
  Slack[0] = quotient.numeratorSlack;
  DivisorSlack[0] = quotient.divisorSlack;
  for (std::size_t k = 1; k < 3; ++k)
  {
    Slack[k] = quotient.SlopeFactor() * Slack[k - 1];
    DivisorSlack[k] = quotient.SlopeFactor() * DivisorSlack[k - 1];
  }
}

void EdgeFunctions::BoundErrors(double rounding)
{
  Error = ErrorOf(Component, Count, Part::Value) * (1.0 + rounding / kUnitRoundoff);
  MapError = ErrorOf(Map, 3, Part::Value);
  for (const Part part : kDerivatives)
  {
    SlopeError = std::max(SlopeError, ErrorOf(Component, Count, part));
    MapSlopeError = std::max(MapSlopeError, ErrorOf(Map, 3, part));
  }
}

std::vector<EdgePolynomials::Function> EdgeFunctions::Functions() const
{
  std::vector<EdgePolynomials::Function> functions;
  functions.reserve(static_cast<std::size_t>(Count) + 1);
  for (int c = 0; c < Count && !Jet; ++c)
  {
    functions.push_back({ &Component, c });
  }
  if (Divisor)
  {
    functions.push_back({ &*Divisor, 0 });
  }
  return functions;
}

void EdgeFunctions::ChooseLevel()
{
  std::vector<RangeIngredient> all;
  all.reserve(4 * (static_cast<std::size_t>(Count) + 3));
  for (int c = 0; c < Count; ++c)
  {
    all.push_back({ &Component, c, Part::Value });
  }
  for (int c = 0; c < 3; ++c)
  {
    all.push_back({ &Map, c, Part::Value });
  }
  AddDerivatives(Map, 0, 3, all);
  AddDerivatives(Component, 0, Count, all);
  if (Divisor)
  {
    all.push_back({ &*Divisor, 0, Part::Value });
    AddDerivatives(*Divisor, 0, 1, all);
  }
  Level = std::max(LevelFor(all), Jet ? Jet->Level() : 0);
  const auto fewer = [](std::size_t coefficients)
  {
    return std::max(
      0, static_cast<int>(std::log2(static_cast<double>(coefficients) / kFewCoefficients)));
  };
  const int besides[2] = { fewer(PieceForm::Of(Map.space, Level).Size()),
    fewer(PieceForm::Of(Component.space, Level).Size()) };
  for (std::size_t k = 0; k < 2; ++k)
  {
    Subdivisions[k] = kMaxSubdivisions[k] - besides[k];
  }
  const auto coefficients = [this](const ScaledModes& modes)
  { return static_cast<std::int64_t>(PieceForm::Of(modes.space, Level).Size()); };
  Cost = EdgePolynomials::CostOf(PieceForm::Of(Map.space, Level).Degree()) +
    EdgePolynomials::CostOf(PieceForm::Of(Component.space, Level).Degree());
  if (Jet)
  {
    const auto [terms, operations] = Jet->WorkOf(Level);
    CostOfJet = kCostOfTerm * terms + kCostOfOperation * operations;
    Cost += CostOfJet;
  }
  while (Free < kMaxFree && Cost << (Free + 1) <= kMaxFreeCost)
  {
    ++Free;
  }
  CostOfView = kCostOfView + kCostOfFourModes * (coefficients(Map) + coefficients(Component)) / 4;
  if (Jet)
  {
    CostOfView += kCostOfView * kViewsOfJet + kCostOfPointOperation * Jet->PointOperations();
  }
}

std::int64_t EdgeFunctions::SampleCost(bool regular) const
{
  return (regular ? kCostOfSample : kCostOfHardSample) + 2 * CostOfView;
}

Vec3 EdgeFunctions::RoundingInUnits(const Vec3& x) const
{
  return edges::kRoundoffs * (glm::abs(x) + glm::abs(Centre)) / Unit;
}

PointValues EdgeFunctions::ImagesAt(std::span<const Vec3> xi) const
{
  return { MapKernels, Map.space, Map.values.data(), 3, std::ldexp(1.0, Map.exponent), xi };
}

/// The values of an expression, with its derivatives by xi.
PointValues EdgeFunctions::ValuesOfJet(std::span<const Vec3> xi) const
{
  const PointValues map = ImagesAt(xi);
  PointValues values;
  std::array<Vec3, PointValues::kRoom> gradients;
  Jet->Evaluate(xi, values.values[0], gradients);
  for (std::size_t i = 0; i < xi.size(); ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      values.slopes[j][i] = Unit *
        (map.slopes[j][i] * gradients[i].x + map.slopes[3 + j][i] * gradients[i].y +
          map.slopes[6 + j][i] * gradients[i].z);
    }
  }
  return values;
}

PointValues EdgeFunctions::ValuesAt(int component, std::span<const Vec3> xi) const
{
  if (Jet)
  {
    return ValuesOfJet(xi);
  }
  const RangeIngredient ingredient{ &Component, component, Part::Value };
  PointValues values(ComponentKernels, Component.space, ingredient.Modes(), 1,
    std::ldexp(1.0, Component.exponent), xi);
  if (Divisor)
  {
    const PointValues divisor(ComponentKernels, Divisor->space, Divisor->values.data(), 1,
      std::ldexp(1.0, Divisor->exponent), xi);
    for (std::size_t i = 0; i < xi.size(); ++i)
    {
      const double over = 1.0 / divisor.values[0][i];
      values.values[0][i] *= over;
      for (std::size_t k = 0; k < 3; ++k)
      {
        values.slopes[k][i] =
          (values.slopes[k][i] - values.values[0][i] * divisor.slopes[k][i]) * over;
      }
    }
  }
  return values;
}

EdgeFunctions::View EdgeFunctions::ViewAt(const Vec3& xi) const
{
  const PointValues map = ImagesAt(std::span(&xi, 1));
  View view{ xi, Vec3(0.0), Mat3(0.0), Mat3(0.0) };
  for (int c = 0; c < 3; ++c)
  {
    view.y[c] = map.values[c][0];
    for (int j = 0; j < 3; ++j)
    {
      view.jacobian[j][c] = map.slopes[3 * c + j][0];
    }
  }
  view.inverse = glm::inverse(view.jacobian);
  return view;
}

bool EdgeFunctions::IsFlatOver(const EtaBox& box) const
{
  return pixelexact::IsFlatOver(Map.space, Map.values.data(), box);
}

EdgeFunctions::ValueAndSlope EdgeFunctions::ValueAndSlopeAt(int component, const Vec3& xi) const
{
  const PointValues at = ValuesAt(component, std::span(&xi, 1));
  return { at.values[0][0], at.SlopeOf(0, 0) };
}

EdgeFunctions::Linear EdgeFunctions::LinearValues(
  const Vec3& xi, std::span<const Vec3> places, double slopeError, const ValueAndSlope* known) const
{
  constexpr std::size_t kMax = Outline::kMaxCorners + Outline::kMaxCuts;
  // The sums over the components: the value, its square, and its product with the sum of all, at
  // each place.
  std::array<double, kMax> values{};
  std::array<double, kMax> squares{};
  std::array<double, kMax> products{};
  Linear linear;
  double square = 0.0;
  double size = 0.0;
  double length = 0.0;
  for (const Vec3& place : places)
  {
    length = std::max(length, SumOf(place - xi));
  }
  for (int c = 0; c < Count; ++c)
  {
    const auto [value, slope] = known != nullptr ? *known : ValueAndSlopeAt(c, xi);
    linear.slope = slope;
    double sum = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const double rise = glm::dot(slope, places[k] - xi);
      values[k] = value + rise;
      sum += values[k];
    }
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      squares[k] += values[k] * values[k];
      products[k] += values[k] * sum;
    }
    square += sum * sum;
    size += std::fabs(value) + LargestOf(slope) * length;
  }
  // A rise is a sum of three products of differences, with about eight roundings of `size`.
  const double slack = edges::kRoundoffs * size + slopeError * length;
  if (Count == 1)
  {
    const auto [least, most] =
      std::minmax_element(values.begin(), values.begin() + std::ssize(places));
    linear.values = { *least - slack, *most + slack };
    return linear;
  }
  // |v| >= v . n for the unit vector n along the sum, which is smallest at a corner.
  const auto least = *std::min_element(products.begin(), products.begin() + std::ssize(places));
  const auto most = *std::max_element(squares.begin(), squares.begin() + std::ssize(places));
  linear.values = { square > 0.0 ? std::max(0.0, least / std::sqrt(square) - 16.0 * slack) : 0.0,
    std::sqrt(most) + slack };
  return linear;
}
} // namespace pixelexact
