// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/EdgeClassifier.h"

#include "Core/Math/Rounding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace pixelexact
{
namespace
{
/// Ends whose value is farther from all iso-values are not tested for plateaus, which only saves
/// time. Relative to the largest magnitude of the element's values.
constexpr double kNearPlateau = 1e-9;
/// Cost of a point that stays unknown (element-tree.md), in nanoseconds.
constexpr std::int64_t kCostOfUnknown = 6'000'000;
/// Limits for parts of a surface that are many pixels wide, for edges and parts of edges, and for
/// squares up to a pixel wide.
constexpr EdgeEffort kForBlocks{ 4, 0 };
constexpr EdgeEffort kForEdges{ EdgeEffort::kAny, 0 };
constexpr EdgeEffort kForSquares{ EdgeEffort::kAny, EdgeEffort::kAny };

bool Meet(const Box3& a, const Box3& b)
{
  return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
    glm::all(glm::lessThanEqual(b.lower, a.upper));
}

/// The values of the scalar that the bounds are of, in ascending order.
std::vector<double> Bounded(const LayerBounds& bounds, std::span<const double> values)
{
  std::vector<double> bounded;
  std::ranges::transform(values, std::back_inserter(bounded),
    [&bounds](double value) { return bounds.ToBounded(value); });
  std::ranges::sort(bounded);
  return bounded;
}

WideOutline RegionOf(const SurfaceEdge& edge)
{
  const Outline outline(edge.from, edge.to);
  return { outline, edge.sagitta + SlackOf(outline.Corners()) };
}
} // namespace

double SlackOf(std::span<const Vec3> corners)
{
  double largest = 0.0;
  for (const Vec3& x : corners)
  {
    largest = std::max({ largest, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z) });
  }
  return 16.0 * kUnitRoundoff * largest;
}

EdgeClassifier::EdgeClassifier(const LayerBounds& bounds, std::span<const double> values,
  EdgeWork* work, std::span<const int> elements)
  : Bounds(bounds)
  , IsoValues(Bounded(bounds, values))
  , Work(work)
{
  for (const int element : elements)
  {
    // Elements without finite values take no iso-value.
    if (bounds.Of(element).HasValues())
    {
      Near.push_back(MakeElement(element));
      Needed = Needed || Near.back().side == kNoSide || Near.back().side != Near.front().side;
    }
  }
  std::ranges::sort(Near, {}, &Element::number);
}

EdgeClassifier::EdgeClassifier(
  const LayerBounds& bounds, std::span<const double> values, EdgeWork* work)
  : Bounds(bounds)
  , IsoValues(Bounded(bounds, values))
  , Work(work)
  , Needed(true)
  , LooksForElements(true)
{
}

EdgeClassifier::Element EdgeClassifier::MakeElement(int element) const
{
  const EdgeBounds& own = Bounds.Of(element);
  const Interval& range = own.Values();
  return { element, Bounds.Index().ElementBox(element), &own,
    Wanted.Meets(range.lower, range.upper) ? kNoSide : SideOf(range.lower) };
}

int EdgeClassifier::SideOf(double value) const
{
  return static_cast<int>(std::ranges::lower_bound(Wanted.values, value) - Wanted.values.begin());
}

std::int64_t EdgeClassifier::SampleCost(const EdgeEnd& a, const EdgeEnd& b) const
{
  std::int64_t most = 0;
  for (const EdgeEnd* end : { &a, &b })
  {
    if (end->element >= 0)
    {
      most = std::max(most, Bounds.Of(end->element).SampleCost(end->point, Work));
    }
  }
  return most;
}

void EdgeClassifier::SpendOnUnknown() const
{
  if (Work)
  {
    Work->Spend(kCostOfUnknown);
  }
}

EdgeEffort EdgeClassifier::With(EdgeEffort effort) const
{
  effort.work = Work;
  return effort;
}

ValueSet EdgeClassifier::NotOn(int side) const
{
  const auto above = static_cast<std::size_t>(side);
  ValueSet others;
  others.lower = above > 0 ? Wanted.values[above - 1] : others.lower;
  others.upper = above < Wanted.values.size() ? Wanted.values[above] : others.upper;
  return others;
}

EdgeFinding EdgeClassifier::Within(
  const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const
{
  const EdgeBounds& bounds = Bounds.Of(a.element);
  const auto range = std::isfinite(edge.sagitta)
    ? bounds.Along(a.point, b.point, edge.sagitta, Work, &Wanted)
    : std::nullopt;
  if (!range)
  {
    return EdgeFinding::Uncovered;
  }
  const double lower = std::min(a.point.value, b.point.value);
  const double upper = std::max(a.point.value, b.point.value);
  if (!Wanted.Meets(lower - range->deviation, upper + range->deviation))
  {
    return EdgeFinding::Out;
  }
  if (IsBetween(lower, upper, range->error))
  {
    return EdgeFinding::In;
  }
  if (Wanted.Meets(lower - range->error, lower + range->error) &&
    Wanted.Meets(upper - range->error, upper + range->error))
  {
    // If the bound at a single point is nearly as wide, no subdivision narrows it.
    const auto atPoint = bounds.Along(a.point, a.point, edge.sagitta, Work);
    if (atPoint && range->deviation <= 2.0 * atPoint->deviation)
    {
      return EdgeFinding::Blurred;
    }
  }
  return EdgeFinding::Open;
}

bool EdgeClassifier::MayTouch(const EdgeEnd& end) const
{
  const double value = end.point.value;
  const double error = Bounds.Of(end.element).ChangeWithin(end.point, 0.0, Work);
  return std::isfinite(error) && Wanted.Meets(value - error, value + error);
}

const Interval& EdgeClassifier::HeldOnPlane(int element) const
{
  const auto found = OnPlane.find(element);
  return found != OnPlane.end()
    ? found->second
    : OnPlane
        .emplace(element,
          Bounds.PlateausOf(element).OnPlane(plane_->Through(), plane_->Normal(SurfacePoint{})))
        .first->second;
}

bool EdgeClassifier::IsOnPlateau(const EdgeEnd& end) const
{
  if (IsHeld)
  {
    return true;
  }
  const double near = kNearPlateau * Bounds.Of(end.element).Values().Magnitude();
  if (!Wanted.Meets(end.point.value - near, end.point.value + near))
  {
    return false;
  }
  const auto holds = [this](const Interval& held)
  { return held.lower <= held.upper && Wanted.Meets(held.lower, held.upper); };
  const ElementPlateaus& plateaus = Bounds.PlateausOf(end.element);
  return holds(plateaus.InElement()) || (end.face >= 0 && holds(plateaus.OnFace(end.face))) ||
    (plane_ != nullptr && holds(HeldOnPlane(end.element)));
}

EdgeFinding EdgeClassifier::Across(const EdgeEnd& a, const EdgeEnd& b) const
{
  const EdgeBounds& ofA = Bounds.Of(a.element);
  const EdgeBounds& ofB = Bounds.Of(b.element);
  const auto [lower, upper] = std::minmax(a.point.value, b.point.value);
  // The errors bound how far the values at the exact points may differ.
  const double error =
    std::max(ofA.ChangeWithin(a.point, 0.0, Work), ofB.ChangeWithin(b.point, 0.0, Work));
  return IsBetween(lower, upper, error) ? EdgeFinding::In : EdgeFinding::Open;
}

bool EdgeClassifier::StaysOn(int side, const SurfaceEdge& edge, bool thorough) const
{
  if (!std::isfinite(edge.sagitta))
  {
    return false;
  }
  const WideOutline region = RegionOf(edge);
  return StaysOn(side, ElementsAt(region), region, With(thorough ? kForEdges : EdgeEffort{}));
}

bool EdgeClassifier::StaysOn(int side, const Outline& part, double sagitta) const
{
  if (!std::isfinite(sagitta))
  {
    return false;
  }
  const WideOutline region{ part, sagitta + SlackOf(part.Corners()) };
  return StaysOn(side, ElementsAt(region), region, With(kForSquares));
}

std::span<const EdgeClassifier::Element> EdgeClassifier::ElementsAt(const WideOutline& region) const
{
  const Box3 box = BoxOf(region);
  Found.clear();
  if (!LooksForElements)
  {
    std::ranges::copy_if(Near, std::back_inserter(Found),
      [&box](const Element& element) { return Meet(box, element.box); });
    return Found;
  }
  std::vector<int> elements;
  Bounds.Index().FindNear(box, elements);
  for (const int element : elements)
  {
    if (Bounds.Of(element).HasValues())
    {
      Found.push_back(MakeElement(element));
    }
  }
  return Found;
}

bool EdgeClassifier::StaysOn(int side, std::span<const Element> elements, const WideOutline& region,
  const EdgeEffort& effort) const
{
  if (side != kNoSide)
  {
    const ValueSet others = NotOn(side);
    return std::ranges::all_of(elements,
      [&](const Element& element)
      { return element.side == side || !element.bounds->MayTake(others, region, effort); });
  }
  // The side is that of any element that the region meets.
  std::vector<int> tried;
  for (const Element& element : elements)
  {
    const std::optional<Interval> values = element.bounds->ValuesIn(region, Wanted, effort);
    if (!values)
    {
      continue;
    }
    const int its = SideOf(values->lower);
    if (Meets(values->lower, values->upper) ||
      (std::ranges::find(tried, its) == tried.end() && StaysOn(its, elements, region, effort)))
    {
      return !Meets(values->lower, values->upper);
    }
    tried.push_back(its);
  }
  return tried.empty();
}

std::optional<PlanarValues> EdgeClassifier::Over(
  const std::array<EdgeEnd, 3>& ends, const Outline& part) const
{
  return Bounds.Of(ends[0].element)
    .Over({ ends[0].point, ends[1].point, ends[2].point }, { part, SlackOf(part.Corners()) },
      Wanted, Work);
}

bool EdgeClassifier::BlockStaysOn(int side, const Outline& part, bool thorough) const
{
  const WideOutline region{ part, SlackOf(part.Corners()) };
  return StaysOn(side, ElementsAt(region), region, With(thorough ? kForEdges : kForBlocks));
}

bool EdgeClassifier::AreOpposite(const EdgeEnd& a, const EdgeEnd& b) const
{
  const auto [lower, upper] = std::minmax(a.point.value, b.point.value);
  // Values that are not finite take no iso-value.
  return std::isfinite(lower) && std::isfinite(upper) && Wanted.Meets(lower, upper);
}

bool EdgeClassifier::IsJump(const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const
{
  const double distance = glm::distance(edge.from, edge.to) + RegionOf(edge).slack;
  const double change = Bounds.Of(a.element).ChangeWithin(a.point, distance, Work) +
    Bounds.Of(b.element).ChangeWithin(b.point, distance, Work);
  return std::fabs(a.point.value - b.point.value) > change;
}
} // namespace pixelexact
