// SPDX-License-Identifier: BSD-3-Clause
// Bounds of EdgeFunctions over boxes, with their errors.
#include "Core/Element/Ranges.h"
#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeFunctions.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
/// The cost of two child nodes in nanoseconds, without that of their polynomials (EdgePolynomials),
/// and the divisor of the latter over neighbouring pieces: in most of them no box ends.
constexpr std::int64_t kCostOfNodes = 25000;
constexpr std::int64_t kShareOfPieces = 4;
/// The largest depth of subdivision in each direction to bound det J.
constexpr int kMaxOfDivisor = 4;

AffineBound Scaled(const AffineBound& bound, int exponent)
{
  const double by = std::ldexp(1.0, exponent);
  return { by * bound.value, { by * bound.slope[0], by * bound.slope[1], by * bound.slope[2] },
    by * bound.radius + std::numeric_limits<double>::min() };
}

/// The same as a function of (xi - the middle) / reach.
AffineForm FormOver(const AffineBound& bound, const Vec3& reach)
{
  AffineForm form;
  form.a = bound.value;
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    form.b[k] = bound.slope[k] * reach[static_cast<int>(k)];
    size += std::fabs(form.b[k]);
  }
  const double radius =
    (bound.radius + edges::kRoundoffs * size) * edges::kUp + std::numeric_limits<double>::min();
  form.e = { -radius, radius };
  return form;
}

/// The inverse of FormOver.
AffineBound BoundOf(const AffineForm& form, const Vec3& reach)
{
  AffineBound bound;
  const double middle = form.e.Middle();
  bound.value = form.a + middle;
  double size = std::fabs(form.a) + std::fabs(middle);
  for (std::size_t k = 0; k < 3; ++k)
  {
    bound.slope[k] = form.b[k] / reach[static_cast<int>(k)];
    size += std::fabs(form.b[k]);
  }
  bound.radius = (form.e.RadiusAround(middle) + edges::kRoundoffs * size) * edges::kUp +
    std::numeric_limits<double>::min();
  return bound;
}

/// Joins the bounds over two parts of a box; slopes become ranges.
JetBounds Join(const JetBounds& a, const JetBounds& b)
{
  JetBounds both = a;
  both.values = Join(a.values, b.values);
  both.isContinuous = a.isContinuous && b.isContinuous;
  both.valueError = std::max(a.valueError, b.valueError);
  both.slopeError = std::max(a.slopeError, b.slopeError);
  for (std::size_t j = 0; j < 3; ++j)
  {
    both.slopes[j] = {};
    both.slopes[j].e = Join(a.slopes[j].Range(), b.slopes[j].Range());
  }
  both.seconds.reset();
  if (a.seconds && b.seconds)
  {
    both.seconds.emplace();
    for (std::size_t p = 0; p < 6; ++p)
    {
      (*both.seconds)[p].e = Join((*a.seconds)[p].Range(), (*b.seconds)[p].Range());
    }
  }
  return both;
}

Interval Widened(const Interval& range, double slack)
{
  return range + Interval(-slack, slack);
}

/// Widens the ranges by `slack`, by order of the derivative.
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

/// Divides the ranges of a numerator, which become those of the quotient F = N / D. Returns F.
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

template <class Visit>
void EdgeFunctions::WithPolynomials(const PieceForm::Piece& piece, const Visit& visit) const
{
  const auto make = [&]
  {
    auto full = std::make_unique<const EdgePolynomials>(Map, Functions(), Level, piece);
    // Over a piece, functions have a lower degree than over the element, up to a small error.
    auto lowered = Level > 0 ? full->Lowered() : nullptr;
    return lowered ? std::move(lowered) : std::move(full);
  };
  Kept->With(piece, make, visit);
}

std::int64_t EdgeFunctions::SubdivisionCost(const EtaBox& box) const
{
  if (Level == 0)
  {
    return kCostOfNodes + Cost;
  }
  std::int64_t ofMap = 0;
  std::int64_t ofRest = 0;
  std::int64_t largest = 0;
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& /*within*/)
    {
      const EdgePolynomials::Cost& own = Costs->Get(Kept->NumberOf(piece),
        [&]
        {
          auto cost = std::make_unique<EdgePolynomials::Cost>();
          WithPolynomials(piece,
            [&](const EdgePolynomials& polynomials) { *cost = polynomials.SubdivisionCost(); });
          return cost;
        });
      ofMap += own.ofMap;
      largest = std::max(largest, own.ofMap);
      ofRest = std::max(ofRest, own.ofRest);
    });
  return kCostOfNodes + std::max(largest, ofMap / kShareOfPieces) + ofRest + CostOfJet;
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
        sum += ingredient.RoundingInKernels(Level, piece);
      }
      error = std::max(error, sum);
    });
  return std::ldexp(error, modes.exponent);
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
  if (Jet)
  {
    return JetOver(box).values;
  }
  std::vector<Interval> components;
  for (int c = 0; c < Count; ++c)
  {
    components.push_back(RangeOver(box, Component, c, Part::Value));
    if (Divisor)
    {
      components.back() = Widened(components.back(), Slack[0]) / DivisorOver(box, kMaxOfDivisor);
    }
  }
  return ValuesOf(components);
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
  const auto count = Jet ? 0 : static_cast<std::size_t>(Count);
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
    if (!Jet)
    {
      scale(ranges.curves->functions.front(), Component.exponent);
    }
  }
  if (Jet)
  {
    AddJet(JetOver(box), ranges);
    return ranges;
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

/// Bounds of the jet over all pieces that the box meets. In one piece, the slopes are affine forms;
/// over several pieces, ranges.
JetBounds EdgeFunctions::JetOver(const EtaBox& box) const
{
  const Vec3 centre = CentreOf(GetShape(), box);
  const Vec3 reach = ReachOf(GetShape(), box);
  JetBounds all;
  int number = 0;
  ForEachPiece(box,
    [&](const PieceForm::Piece& piece, const Box3& within)
    {
      JetBounds own;
      JetPolynomials->With(
        piece, [&] { return MakeJetBatches(piece); },
        [&](const JetBatches& list)
        {
          std::vector<Interval> hulls(list.count);
          std::vector<AffineForm> forms(list.count);
          std::vector<Interval> some;
          std::vector<AffineBound> bounds;
          for (const auto& [places, polynomials] : list.batches)
          {
            some.resize(places.size());
            bounds.resize(places.size());
            polynomials.BoundsOver(within, some,
              EdgePolynomials::PlacesIn(
                GetShape(), PartOfBox(box, piece), centre, polynomials.Degree()),
              bounds);
            for (std::size_t k = 0; k < places.size(); ++k)
            {
              hulls[places[k]] = some[k];
              forms[places[k]] = FormOver(bounds[k], reach);
            }
          }
          own = Jet->Over(forms, hulls);
          own.reach = reach;
        });
      all = number++ == 0 ? own : Join(all, own);
    });
  return all;
}

std::size_t EdgeFunctions::JetBatches::Bytes() const
{
  std::size_t bytes = 0;
  for (const Batch& batch : batches)
  {
    bytes += batch.polynomials.Bytes();
  }
  return bytes;
}

/// Those of the map often have much lower degrees than those of fields, and are many.
std::unique_ptr<const EdgeFunctions::JetBatches> EdgeFunctions::MakeJetBatches(
  const PieceForm::Piece& piece) const
{
  const std::vector<BoxPolynomial> polynomials = Jet->Polynomials(Level, piece);
  const auto highest = [](const BoxPolynomial& one) { return std::ranges::max(one.degree); };
  int most = 0;
  for (const BoxPolynomial& one : polynomials)
  {
    most = std::max(most, highest(one));
  }
  auto made = std::make_unique<JetBatches>();
  made->count = polynomials.size();
  for (const bool isLow : { true, false })
  {
    std::vector<std::size_t> places;
    std::vector<BoxPolynomial> chosen;
    // The degree is at least 1 in each direction, as that of xi.
    Degrees degree{ 1, 1, 1 };
    for (std::size_t k = 0; k < polynomials.size(); ++k)
    {
      const BoxPolynomial& one = polynomials[k];
      if ((2 * highest(one) <= most + 1) == isLow)
      {
        places.push_back(k);
        chosen.push_back(one);
        std::ranges::transform(
          degree, one.degree, degree.begin(), [](int a, int b) { return std::max(a, b); });
      }
    }
    if (!chosen.empty())
    {
      made->batches.push_back({ std::move(places), PolynomialBatch(degree, chosen) });
    }
  }
  return made;
}

EtaBox EdgeFunctions::PartOfBox(const EtaBox& box, const PieceForm::Piece& piece) const
{
  EtaBox part = box;
  for (int d = 0; d < 3; ++d)
  {
    const double first = std::ldexp(piece[static_cast<std::size_t>(d)], 1 - Level) - 1.0;
    part.lower[d] = std::max(part.lower[d], first);
    part.upper[d] = std::min(part.upper[d], first + std::ldexp(1.0, 1 - Level));
  }
  return part;
}

/// Where second derivatives are not available, the function is P + E with a quadratic P, whose
/// second derivatives are the symmetric part of the slopes' own, and |E'| at most `beside`.
void EdgeFunctions::AddJet(const JetBounds& jet, Derivatives& ranges) const
{
  ranges.values = jet.values;
  ranges.errors = { jet.valueError, jet.slopeError };
  if (!jet.isContinuous)
  {
    ranges.errors.value = kInfinity;
  }
  HessianFunction::XiRanges& own = ranges.components.emplace_back();
  const Vec3& reach = jet.reach;
  double by[3][3];
  for (std::size_t j = 0; j < 3; ++j)
  {
    own.first[j] = jet.slopes[j].Range();
    for (std::size_t k = 0; k < 3; ++k)
    {
      by[j][k] = jet.slopes[j].b[k] / reach[static_cast<int>(k)];
    }
  }
  EdgePolynomials::SecondBounds seconds;
  for (std::size_t p = 0; p < 6 && jet.seconds; ++p)
  {
    own.second[p] = (*jet.seconds)[p].Range();
    seconds[p] = BoundOf((*jet.seconds)[p], reach);
  }
  for (std::size_t p = 0; p < 6 && !jet.seconds; ++p)
  {
    const double second =
      0.5 * (by[edges::kRows[p]][edges::kColumns[p]] + by[edges::kColumns[p]][edges::kRows[p]]);
    own.second[p] = second;
    seconds[p] = { second, {}, 0.0 };
  }
  for (std::size_t j = 0; j < 3 && !jet.seconds; ++j)
  {
    const AffineForm& slope = jet.slopes[j];
    double beside = 0.5 * slope.e.Width();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double half = 0.5 * (by[j][k] - by[k][j]);
      beside +=
        (std::fabs(half) + edges::kRoundoffs * (std::fabs(by[j][k]) + std::fabs(by[k][j]))) *
        reach[static_cast<int>(k)];
    }
    ranges.beside[j] = beside * edges::kUp;
  }
  if (ranges.curves)
  {
    ranges.curves->functions.push_back(seconds);
  }
}

Interval EdgeFunctions::DivisorOver(const EtaBox& box, int subdivisions) const
{
  const Interval whole = Widened(RangeOver(box, *Divisor, 0, Part::Value), DivisorSlack[0]);
  if (subdivisions == 0 || !whole.Contains(0.0))
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
    all = Join(all, DivisorOver(part, subdivisions - 1));
    if (all.Contains(0.0))
    {
      break;
    }
  }
  return all;
}

EdgeFunctions::Errors EdgeFunctions::ErrorsWith(const Derivatives& derivatives) const
{
  if (Jet)
  {
    return derivatives.errors;
  }
  if (!Divisor)
  {
    return { Error, SlopeError };
  }
  // The error of N / D is (dN + F dD) / D, and its slope is (N' - F D') / D.
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
} // namespace pixelexact
