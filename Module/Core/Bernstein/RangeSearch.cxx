// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Bernstein/RangeSearch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
/// The memory limit of one search: 64 MiB.
constexpr std::size_t kMaxHeld = std::size_t{ 1 } << 23U;
/// The largest ratio of a box's longest and shortest sides, as a power of two.
constexpr int kMaxUneven = 20;
/// Subdivision does not help where an enclosure exceeds the attained range by less than this many
/// times the width of the enclosure of a point.
constexpr double kRoundingOnly = 8.0;
/// A gap below this fraction of the largest magnitude is rounding.
constexpr double kFloor = 0x1p-40;
/// A gap below this size is rounding. Functions are searched in units of their coefficients.
constexpr double kSmallest = 0x1p-400;

int Total(const std::array<int, 3>& subdivisions)
{
  return subdivisions[0] + subdivisions[1] + subdivisions[2];
}

Vec3 CornerOf(const Box3& box, unsigned corner)
{
  const auto at = [&](int d)
  { return ((corner >> static_cast<unsigned>(d)) & 1U) != 0 ? box.upper[d] : box.lower[d]; };
  return { at(0), at(1), at(2) };
}

/// The point with the coordinates t in the box's own [-1, 1]^3.
Vec3 PointOf(const Box3& box, const std::array<double, 3>& t)
{
  const auto at = [&](int d)
  {
    const double part = 0.5 + 0.5 * t[static_cast<std::size_t>(d)];
    return std::clamp(std::lerp(box.lower[d], box.upper[d], part), box.lower[d], box.upper[d]);
  };
  return { at(0), at(1), at(2) };
}

int SplitDirection(const RangeBox& box, int difference)
{
  const int least = std::ranges::min(box.subdivisions);
  int best = -1;
  double most = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    if (box.subdivisions[static_cast<std::size_t>(d)] - least > kMaxUneven)
    {
      continue;
    }
    double variation = 0.0;
    for (const BoxPolynomial& polynomial : box.polynomials)
    {
      variation += polynomial.Variation(d, difference);
    }
    if (variation > most)
    {
      most = variation;
      best = d;
    }
  }
  return best >= 0
    ? best
    : static_cast<int>(std::ranges::min_element(box.subdivisions) - box.subdivisions.begin());
}
} // namespace

PointValue RangeFunction::AtLikelyMinimum(std::span<const BoxPolynomial> /*polynomials*/) const
{
  return {};
}

void AttainedValues::Add(const Interval& value, const Vec3& point)
{
  Add({ { value.upper, value.lower }, point, point });
}

void AttainedValues::Add(const AttainedValues& others)
{
  if (others.values.lower < values.lower)
  {
    values.lower = others.values.lower;
    lowerPoint = others.lowerPoint;
  }
  if (others.values.upper > values.upper)
  {
    values.upper = others.values.upper;
    upperPoint = others.upperPoint;
  }
}

double AllowedGap(const CertifiedRange& range, double tolerance)
{
  const double width = std::max(range.attained.upper - range.attained.lower, 0.0);
  const double allowed =
    std::max({ tolerance * width, kFloor * range.outer.Magnitude(), kSmallest });
  return std::isfinite(allowed) ? allowed : kSmallest;
}

bool IsWithin(const CertifiedRange& range, double tolerance)
{
  const double allowed = AllowedGap(range, tolerance);
  return range.GapBelow() <= allowed && range.GapAbove() <= allowed;
}

AttainedValues RangeBox::Look(const RangeFunction& function)
{
  bound = Intersect(bound, function.Enclose(polynomials));
  rounding = 0.0;
  lowestCorner = std::numeric_limits<double>::infinity();
  AttainedValues attained;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Interval at = function.AtCorner(polynomials, corner);
    const Interval value = Intersect(bound, at);
    rounding = std::max(rounding, at.IsFinite() ? at.Width() : 0.0);
    lowestCorner = std::min(lowestCorner, value.lower);
    attained.Add(value, CornerOf(place, corner));
  }
  return attained;
}

RangeBox RangeBox::Subdivide(const RangeFunction& function)
{
  if (remake)
  {
    polynomials = remake();
    remake = nullptr;
  }
  const int direction = SplitDirection(*this, function.TellingDifference());
  ++subdivisions[static_cast<std::size_t>(direction)];
  RangeBox upper;
  upper.bound = bound;
  upper.subdivisions = subdivisions;
  upper.place = place;
  upper.place.lower[direction] = place.upper[direction] =
    0.5 * (place.lower[direction] + place.upper[direction]);
  for (BoxPolynomial& polynomial : polynomials)
  {
    upper.polynomials.push_back(polynomial.Subdivide(direction));
  }
  return upper;
}

std::size_t RangeBox::Held() const
{
  std::size_t count = 0;
  for (const BoxPolynomial& polynomial : polynomials)
  {
    count += polynomial.b.size();
  }
  return count;
}

RangeSearch::RangeSearch(const RangeFunction& function, const Interval& known)
  : Function(function)
  , Attained{ known }
{
}

void RangeSearch::Add(RangeBox box)
{
  Attained.Add(box.Look(Function));
  ++Count;
  const bool every = Total(box.subdivisions) % 3 == 0;
  if (every && box.bound.lower < Attained.values.lower)
  {
    const PointValue found = Function.AtLikelyMinimum(box.polynomials);
    Attained.Add(found.value, PointOf(box.place, found.t));
  }
  if (box.remake)
  {
    box.polynomials.clear();
    box.polynomials.shrink_to_fit();
  }
  if (!Attained.values.Contains(box.bound))
  {
    Held += box.Held();
    Boxes.push_back(std::move(box));
  }
}

CertifiedRange RangeSearch::Current() const
{
  CertifiedRange range;
  range.attained = Attained.values;
  range.lowerPoint = Attained.lowerPoint;
  range.upperPoint = Attained.upperPoint;
  range.boxes = Count;
  // The boxes that were dropped hold only values between the attained ones.
  range.outer = { range.attained.lower, range.attained.upper };
  for (const RangeBox& box : Boxes)
  {
    range.outer.lower = std::min(range.outer.lower, box.bound.lower);
    range.outer.upper = std::max(range.outer.upper, box.bound.upper);
  }
  if (range.outer.IsEmpty())
  {
    std::swap(range.outer.lower, range.outer.upper);
  }
  return range;
}

bool RangeSearch::Refine(End end)
{
  const auto reach = [end](const RangeBox& box)
  { return end == End::Lower ? -box.bound.lower : box.bound.upper; };
  const auto worst = std::ranges::max_element(
    Boxes, [&](const RangeBox& a, const RangeBox& b) { return reach(a) < reach(b); });
  if (worst == Boxes.end())
  {
    return false;
  }
  const double beyond =
    reach(*worst) - (end == End::Lower ? -Attained.values.lower : Attained.values.upper);
  if (Held > kMaxHeld || !(beyond > 0.0) || beyond <= kRoundingOnly * worst->rounding)
  {
    return false;
  }
  RangeBox lower = std::move(*worst);
  *worst = std::move(Boxes.back());
  Boxes.pop_back();
  Held -= lower.Held();
  RangeBox upper = lower.Subdivide(Function);
  Add(std::move(lower));
  Add(std::move(upper));
  return true;
}

CertifiedRange SearchRange(RangeSearch& search, double tolerance, double gap, int budget)
{
  CertifiedRange range = search.Current();
  while (true)
  {
    const double allowed = std::max(gap, AllowedGap(range, tolerance));
    range.met = range.GapBelow() <= allowed && range.GapAbove() <= allowed;
    if (range.met || range.boxes >= budget)
    {
      return range;
    }
    const bool below = range.GapBelow() > range.GapAbove();
    if (!search.Refine(below ? RangeSearch::End::Lower : RangeSearch::End::Upper) &&
      !search.Refine(below ? RangeSearch::End::Upper : RangeSearch::End::Lower))
    {
      return range;
    }
    range = search.Current();
  }
}
} // namespace pixelexact
