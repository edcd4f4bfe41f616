// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeFunctions.h"

#include "Core/Element/Ranges.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"

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
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Halvings of boxes on which the map is not regular, and of those where it is: of functions with
/// few coefficients. Nodes of many cost more, and there are fewer of them.
constexpr int kMostHalvings[2] = { 15, 17 };
constexpr double kFewCoefficients = 216.0;
/// What all elements' polynomials may take; of others they are made each time.
constexpr std::int64_t kMostBytes = std::int64_t{ 256 } << 20;
std::atomic<std::int64_t> bytesKept{ 0 };
/// Halvings of each direction after which det J is given up.
constexpr int kMostOfDivisor = 4;
constexpr Part kBy[3] = { Part::ByXi1, Part::ByXi2, Part::ByXi3 };

AffineBound Scaled(const AffineBound& bound, int exponent)
{
  const double by = std::ldexp(1.0, exponent);
  return { by * bound.value, { by * bound.slope[0], by * bound.slope[1], by * bound.slope[2] },
    by * bound.radius + std::numeric_limits<double>::min() };
}

Interval Widened(const Interval& range, double slack)
{
  return range + Interval(-slack, slack);
}

/// By order of the derivative.
void Widen(HessianFunction::XiRanges& ranges, Interval& value, const std::array<double, 3>& slack)
{
  value = Widened(value, slack[0]);
  for (Interval& first : ranges.first)
  {
    first = Widened(first, slack[1]);
  }
  for (Interval& second : ranges.second)
  {
    second = Widened(second, slack[2]);
  }
}

/// Of a numerator, which becomes the quotient F = N / D; returns F.
Interval Divide(HessianFunction::XiRanges& ranges, const HessianFunction::XiRanges& divisor,
  const Interval& numerator, const Interval& by)
{
  const Interval value = numerator / by;
  for (std::size_t k = 0; k < 3; ++k)
  {
    ranges.first[k] = (ranges.first[k] - value * divisor.first[k]) / by;
  }
  for (std::size_t p = 0; p < 6; ++p)
  {
    const std::size_t i = edges::kRows[p];
    const std::size_t j = edges::kColumns[p];
    ranges.second[p] = (ranges.second[p] - ranges.first[i] * divisor.first[j] -
                         ranges.first[j] * divisor.first[i] - value * divisor.second[p]) /
      by;
  }
  return value;
}
} // namespace

EdgeFunctions::EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element,
  const Field& field, int component, double rounding)
  : EdgeFunctions(
      mesh, bounds, element, ModesOf(mesh, element, field, component, rounding), rounding)
{
}

EdgeFunctions::EdgeFunctions(const Mesh& mesh, const ElementBounds& bounds, int element)
  : EdgeFunctions(mesh, bounds, element,
      { ScaledModes(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 0), 0, std::nullopt,
        true },
      0.0)
{
}

EdgeFunctions::Modes EdgeFunctions::ModesOf(
  const Mesh& mesh, int element, const Field& field, int component, double rounding)
{
  const Space& space = field.values.SpaceOf(element);
  const int count = component < 0 ? field.values.components : 1;
  // Of mapped vectors each component is made of all.
  const bool isMapped = field.mapping != Mapping::Identity;
  ScaledModes modes(space,
    field.values.Coefficients(element) +
      static_cast<std::ptrdiff_t>(isMapped ? 0 : std::max(component, 0)) * space.Modes(),
    isMapped ? field.values.components : count);
  const bool finite = modes.finite;
  if (!isMapped || !finite)
  {
    return { std::move(modes), count, std::nullopt, finite };
  }
  std::optional<QuotientModes> quotient =
    MakeQuotientModes(mesh, element, field, component, rounding);
  const bool known = quotient.has_value();
  return { known ? quotient->numerators : std::move(modes), count, std::move(quotient), known };
}

EdgeFunctions::EdgeFunctions(
  const Mesh& mesh, const ElementBounds& bounds, int element, Modes modes, double rounding)
  : Map(mesh.map.SpaceOf(element), mesh.map.Coefficients(element), 3)
  , Component(std::move(modes.component))
  , Divisor(modes.quotient ? std::optional(modes.quotient->divisor) : std::nullopt)
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
  Kept = std::make_unique<MadeOnDemand<EdgePolynomials>>(std::size_t{ 1 } << (3 * Level));
  Range = ValuesOver({});
  BoundErrors(rounding);
  if (modes.quotient)
  {
    const QuotientModes& quotient = *modes.quotient;
    // Of kernels, and of ValuesAt.
    Error += Count * (quotient.numeratorError + Slack[0]);
    DivisorError = ErrorOf(*Divisor, 1, Part::Value) + quotient.divisorError + DivisorSlack[0];
    for (const Part part : kBy)
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
  for (const Part part : kBy)
  {
    SlopeError = std::max(SlopeError, ErrorOf(Component, Count, part));
    MapSlopeError = std::max(MapSlopeError, ErrorOf(Map, 3, part));
  }
}

EdgeFunctions::Errors EdgeFunctions::ErrorsWith(const Derivatives& derivatives) const
{
  if (!Divisor)
  {
    return { Error, SlopeError };
  }
  // N / D moves by (dN + F dD) / D, and its slope is (N' - F D') / D.
  const Interval& by = derivatives.divisor;
  const double least = by.Contains(0.0) ? 0.0 : std::min(std::fabs(by.lower), std::fabs(by.upper));
  const double most = derivatives.values.Magnitude();
  double slope = 0.0;
  double slopeOfDivisor = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    slopeOfDivisor = std::max(slopeOfDivisor, derivatives.divisorSlopes[k].Magnitude());
    for (const HessianFunction::XiRanges& component : derivatives.components)
    {
      slope = std::max(slope, component.first[k].Magnitude());
    }
  }
  const double value = 2.0 * (Error + most * DivisorError) / least;
  return { value,
    2.0 * (SlopeError + most * DivisorSlopeError + value * slopeOfDivisor + slope * DivisorError) /
      least };
}

Interval EdgeFunctions::DivisorOver(const EtaBox& box, int halvings) const
{
  const Interval whole = Widened(RangeOver(box, *Divisor, 0, Part::Value), DivisorSlack[0]);
  if (halvings == 0 || !whole.Contains(0.0))
  {
    return whole;
  }
  const Vec3 middle = 0.5 * (box.lower + box.upper);
  Interval all(kInfinity, -kInfinity);
  for (int corner = 0; corner < 8; ++corner)
  {
    EtaBox part = box;
    for (int d = 0; d < 3; ++d)
    {
      ((corner >> d & 1) != 0 ? part.lower : part.upper)[d] = middle[d];
    }
    all = Join(all, DivisorOver(part, halvings - 1));
    if (all.Contains(0.0))
    {
      break;
    }
  }
  return all;
}

std::vector<EdgePolynomials::Function> EdgeFunctions::Functions() const
{
  std::vector<EdgePolynomials::Function> functions;
  functions.reserve(static_cast<std::size_t>(Count) + 1);
  for (int c = 0; c < Count; ++c)
  {
    functions.push_back({ &Component, c });
  }
  if (Divisor)
  {
    functions.push_back({ &*Divisor, 0 });
  }
  return functions;
}

EdgeFunctions::~EdgeFunctions()
{
  bytesKept -= Bytes.load();
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
  Level = LevelFor(all);
  const auto fewer = [](std::size_t coefficients)
  {
    return std::max(
      0, static_cast<int>(std::log2(static_cast<double>(coefficients) / kFewCoefficients)));
  };
  const int besides[2] = { fewer(PieceForm::Of(Map.space, Level).Size()),
    fewer(PieceForm::Of(Component.space, Level).Size()) };
  for (std::size_t k = 0; k < 2; ++k)
  {
    Halvings[k] = kMostHalvings[k] - besides[k];
  }
}

Vec3 EdgeFunctions::RoundingInUnits(const Vec3& x) const
{
  return edges::kRoundoffs * (glm::abs(x) + glm::abs(Centre)) / Unit;
}

PointValues EdgeFunctions::ImagesAt(std::span<const Vec3> xi) const
{
  return { MapKernels, Map.space, Map.values.data(), 3, std::ldexp(1.0, Map.exponent), xi };
}

PointValues EdgeFunctions::ValuesAt(int component, std::span<const Vec3> xi) const
{
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

EdgeFunctions::Linear EdgeFunctions::LinearValues(
  const Vec3& xi, std::span<const Vec3> places, double slopeError) const
{
  constexpr std::size_t kMost = Outline::kMostCorners + Outline::kMostCuts;
  // Of all components: at each place the value, its square, and its product with the sum of all.
  std::array<double, kMost> values{};
  std::array<double, kMost> squares{};
  std::array<double, kMost> products{};
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
    const PointValues component = ValuesAt(c, std::span(&xi, 1));
    const Vec3 slope = component.SlopeOf(0, 0);
    linear.slope = slope;
    double sum = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const double rise = glm::dot(slope, places[k] - xi);
      values[k] = component.values[0][0] + rise;
      sum += values[k];
    }
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      squares[k] += values[k] * values[k];
      products[k] += values[k] * sum;
    }
    square += sum * sum;
    size += std::fabs(component.values[0][0]) + LargestOf(slope) * length;
  }
  const double slack = 1e-14 * size + slopeError * length;
  if (Count == 1)
  {
    const auto [least, most] =
      std::minmax_element(values.begin(), values.begin() + std::ssize(places));
    linear.values = { *least - slack, *most + slack };
    return linear;
  }
  // |v| >= v . n of the unit vector n along the sum, which is least at a corner.
  const auto least = *std::min_element(products.begin(), products.begin() + std::ssize(places));
  const auto most = *std::max_element(squares.begin(), squares.begin() + std::ssize(places));
  linear.values = { square > 0.0 ? std::max(0.0, least / std::sqrt(square) - 16.0 * slack) : 0.0,
    std::sqrt(most) + slack };
  return linear;
}

double EdgeFunctions::ErrorOf(const ScaledModes& modes, int components, Part part) const
{
  double error = 0.0;
  ForEachPiece({},
    [&](const PieceForm::Piece& piece, const Box3& /*within*/)
    {
      double sum = 0.0;
      for (int c = 0; c < components; ++c)
      {
        const RangeIngredient ingredient{ &modes, c, part };
        sum += PieceForm::Of(modes.space, Level).ErrorBound(part, piece, ingredient.Modes());
      }
      error = std::max(error, sum);
    });
  return std::ldexp(4.0 * error, modes.exponent);
}

template <class Visit>
void EdgeFunctions::ForEachPiece(const EtaBox& box, const Visit& visit) const
{
  const int pieces = 1 << Level;
  for (int i = 0; i < pieces * pieces * pieces; ++i)
  {
    const PieceForm::Piece piece{ i / (pieces * pieces), i / pieces % pieces, i % pieces };
    const Box3 within = PartInPiece({ box.lower, box.upper }, Level, piece);
    if (within.lower.x < within.upper.x && within.lower.y < within.upper.y &&
      within.lower.z < within.upper.z)
    {
      visit(piece, within);
    }
  }
}

Interval EdgeFunctions::RangeOver(
  const EtaBox& box, const ScaledModes& modes, int component, Part part) const
{
  Interval range(kInfinity, -kInfinity);
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      range =
        Join(range, RangeIngredient{ &modes, component, part }.Over(Level, piece, within).Hull());
    });
  return Scaled(range, modes.exponent);
}

Interval EdgeFunctions::ValuesOf(std::span<const Interval> components) const
{
  if (Count == 1)
  {
    return components.front();
  }
  Interval square(0.0);
  for (const Interval& component : components)
  {
    square += Square(component);
  }
  return Sqrt(square);
}

Interval EdgeFunctions::ValuesOver(const EtaBox& box) const
{
  std::vector<Interval> components;
  for (int c = 0; c < Count; ++c)
  {
    components.push_back(RangeOver(box, Component, c, Part::Value));
    if (Divisor)
    {
      components.back() = Widened(components.back(), Slack[0]) / DivisorOver(box, kMostOfDivisor);
    }
  }
  return ValuesOf(components);
}

template <class Visit>
void EdgeFunctions::WithPolynomials(const PieceForm::Piece& piece, const Visit& visit) const
{
  const int number = (((piece[0] << Level) + piece[1]) << Level) + piece[2];
  const auto at = static_cast<std::size_t>(number);
  const auto make = [&]
  { return std::make_unique<const EdgePolynomials>(Map, Functions(), Level, piece); };
  const EdgePolynomials* made = Kept->IfMade(at);
  if (!made && bytesKept.load(std::memory_order_relaxed) < kMostBytes)
  {
    made = &Kept->Get(at, make);
    // Once more, where two threads made them: a bound all the same, until it is all given back.
    bytesKept += static_cast<std::int64_t>(made->Bytes());
    Bytes += static_cast<std::int64_t>(made->Bytes());
  }
  visit(made ? *made : *make());
}

EdgeFunctions::MapRanges EdgeFunctions::MapOver(const EtaBox& box) const
{
  MapRanges ranges;
  std::array<Interval, 3> image;
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      WithPolynomials(piece,
        [&](const EdgePolynomials& polynomials)
        { ranges.ofPieces.push_back(polynomials.MapOver(within)); });
      const EdgePolynomials::MapHulls& here = ranges.ofPieces.back();
      const bool first = ranges.ofPieces.size() == 1;
      const auto add = [&](Interval& to, const Interval& hull)
      {
        const Interval range = Scaled(hull, Map.exponent);
        to = first ? range : Join(to, range);
      };
      for (std::size_t c = 0; c < 3; ++c)
      {
        add(image[c], here.image[c]);
        for (std::size_t k = 0; k < 3; ++k)
        {
          add(ranges.slopes[c][k], here.slopes[c][k]);
        }
      }
    });
  for (std::size_t c = 0; c < 3; ++c)
  {
    const int d = static_cast<int>(c);
    const double slack = Unsure[c];
    const Interval x = Interval(Unit) * (image[c] + Interval(-slack, slack)) + Interval(Centre[d]);
    ranges.image.lower[d] = x.lower;
    ranges.image.upper[d] = x.upper;
  }
  return ranges;
}

EdgeFunctions::Derivatives EdgeFunctions::DerivativesOver(
  const EtaBox& box, const MapRanges& map) const
{
  Derivatives ranges;
  const auto count = static_cast<std::size_t>(Count);
  const bool bounded = map.ofPieces.size() == 1 && Count == 1 && !Divisor;
  std::vector<Interval> values(count + (Divisor ? 1 : 0));
  ranges.components.resize(values.size());
  std::size_t number = 0;
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      const bool first = number == 0;
      EdgePolynomials::Hulls here;
      WithPolynomials(piece,
        [&](const EdgePolynomials& polynomials)
        { here = polynomials.Over(within, map.ofPieces[number], bounded ? &box : nullptr); });
      ++number;
      const auto add = [&](Interval& to, const Interval& hull, int exponent)
      { to = first ? Scaled(hull, exponent) : Join(to, Scaled(hull, exponent)); };
      const auto addAll =
        [&](HessianFunction::XiRanges& to, const HessianFunction::XiRanges& hulls, int exponent)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          add(to.first[k], hulls.first[k], exponent);
        }
        for (std::size_t k = 0; k < 6; ++k)
        {
          add(to.second[k], hulls.second[k], exponent);
        }
      };
      for (std::size_t c = 0; c < 3; ++c)
      {
        addAll(ranges.map[c], here.map[c], Map.exponent);
      }
      for (std::size_t c = 0; c < values.size(); ++c)
      {
        const int exponent = c < count ? Component.exponent : Divisor->exponent;
        addAll(ranges.components[c], here.functions[c], exponent);
        add(values[c], here.values[c], exponent);
      }
      ranges.curves = std::move(here.curves);
    });
  if (ranges.curves)
  {
    const auto scale = [](EdgePolynomials::SecondBounds& bounds, int exponent)
    {
      for (AffineBound& bound : bounds)
      {
        bound = Scaled(bound, exponent);
      }
    };
    for (EdgePolynomials::SecondBounds& bounds : ranges.curves->map)
    {
      scale(bounds, Map.exponent);
    }
    scale(ranges.curves->functions.front(), Component.exponent);
  }
  if (Divisor)
  {
    for (std::size_t c = 0; c <= count; ++c)
    {
      Widen(ranges.components[c], values[c], c < count ? Slack : DivisorSlack);
    }
    const HessianFunction::XiRanges divisor = ranges.components.back();
    ranges.divisor = values.back();
    ranges.divisorSlopes = divisor.first;
    for (std::size_t c = 0; c < count; ++c)
    {
      values[c] = Divide(ranges.components[c], divisor, values[c], ranges.divisor);
    }
    values.pop_back();
    ranges.components.pop_back();
  }
  ranges.values = ValuesOf(values);
  return ranges;
}
} // namespace pixelexact
