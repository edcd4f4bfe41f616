// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/EdgeJudge.h"

#include "Core/Math/Rounding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Of the largest magnitude of an element's values: rounding beyond which a value that is met by
/// an end up to rounding is not told from one that is missed.
constexpr double kTouch = 1e-13;

/// How far an end may be off, by the rounding of rays and hits.
double SlackOf(const SurfaceEdge& edge)
{
  double largest = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    largest = std::max({ largest, std::fabs(edge.from[d]), std::fabs(edge.to[d]) });
  }
  return edge.sagitta + 16.0 * kUnitRoundoff * largest;
}
} // namespace

EdgeJudge::EdgeJudge(
  const LayerBounds& bounds, std::span<const double> values, std::span<const int> elements)
  : Bounds(bounds)
  , Wanted{ values }
{
  for (const int element : elements)
  {
    // What is not finite has no values.
    if (bounds.Of(element).Values().IsFinite())
    {
      Near.push_back(MakeElement(element));
      Needed = Needed || Near.back().side == kNoSide || Near.back().side != Near.front().side;
    }
  }
  std::ranges::sort(Near, {}, &Element::number);
}

EdgeJudge::EdgeJudge(const LayerBounds& bounds, std::span<const double> values)
  : Bounds(bounds)
  , Wanted{ values }
  , Needed(true)
  , LooksForElements(true)
{
}

EdgeJudge::Element EdgeJudge::MakeElement(int element) const
{
  const EdgeBounds& own = Bounds.Of(element);
  const Interval& range = own.Values();
  return { element, Bounds.Index().ElementBox(element), &own,
    Wanted.Meets(range.lower, range.upper) ? kNoSide : SideOf(range.lower) };
}

int EdgeJudge::SideOf(double value) const
{
  return static_cast<int>(std::ranges::lower_bound(Wanted.values, value) - Wanted.values.begin());
}

ValueSet EdgeJudge::NotOn(int side) const
{
  if (side == kNoSide)
  {
    return Wanted;
  }
  const auto above = static_cast<std::size_t>(side);
  ValueSet others;
  others.lower = above > 0 ? Wanted.values[above - 1] : others.lower;
  others.upper = above < Wanted.values.size() ? Wanted.values[above] : others.upper;
  return others;
}

EdgeFinding EdgeJudge::Within(const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const
{
  const EdgeBounds& bounds = Bounds.Of(a.element);
  const auto range =
    std::isfinite(edge.sagitta) ? bounds.Along(a.point, b.point, edge.sagitta) : std::nullopt;
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
  const double error = range->error;
  if (lower + error < upper - error && Wanted.Meets(lower + error, upper - error))
  {
    return EdgeFinding::In;
  }
  const bool touches =
    Wanted.Meets(lower - error, lower + error) || Wanted.Meets(upper - error, upper + error);
  return touches && error <= kTouch * bounds.Values().Magnitude() ? EdgeFinding::Touching
                                                                  : EdgeFinding::Open;
}

bool EdgeJudge::StaysOn(int side, const SurfaceEdge& edge, bool thorough) const
{
  if (!std::isfinite(edge.sagitta))
  {
    return false;
  }
  const double slack = SlackOf(edge);
  const Vec3 lower = glm::min(edge.from, edge.to) - slack;
  const Vec3 upper = glm::max(edge.from, edge.to) + slack;
  const ValueSet others = NotOn(side);
  const auto leaves = [&](const Element& element)
  {
    const Box3& box = element.box;
    return !element.StaysOn(side) &&
      !(lower.x > box.upper.x || upper.x < box.lower.x || lower.y > box.upper.y ||
        upper.y < box.lower.y || lower.z > box.upper.z || upper.z < box.lower.z) &&
      element.bounds->MayTake(others, edge.from, edge.to, slack, thorough);
  };
  if (!LooksForElements)
  {
    return std::ranges::none_of(Near, leaves);
  }
  std::vector<int> elements;
  Bounds.Index().FindNear({ lower, upper }, elements);
  return std::ranges::none_of(elements,
    [&](int element)
    { return Bounds.Of(element).Values().IsFinite() && leaves(MakeElement(element)); });
}

bool EdgeJudge::AreOpposite(const EdgeEnd& a, const EdgeEnd& b) const
{
  const double lower = std::min(a.point.value, b.point.value);
  const double upper = std::max(a.point.value, b.point.value);
  return Wanted.Meets(lower, upper);
}

bool EdgeJudge::IsJump(const EdgeEnd& a, const EdgeEnd& b, const SurfaceEdge& edge) const
{
  const double distance = glm::distance(edge.from, edge.to) + SlackOf(edge);
  const double change = Bounds.Of(a.element).ChangeWithin(a.point, distance) +
    Bounds.Of(b.element).ChangeWithin(b.point, distance);
  return std::fabs(a.point.value - b.point.value) > change;
}
} // namespace pixelexact
