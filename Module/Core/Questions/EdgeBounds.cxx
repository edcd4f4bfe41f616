// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeBounds.h"

#include "Core/Questions/EdgeArithmetic.h"
#include "Core/Questions/EdgeMeeting.h"
#include "Core/Questions/LocalCurves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
using namespace edges;

namespace
{
/// Errors of located points up to this, in xi, are assumed; larger ones are measured.
constexpr double kMaxAssumed = 1e-10;
/// Smaller nodes are visited where `loose` exceeds this fraction of the bound.
constexpr double kLoose = 0.25;
/// Smaller nodes are visited where the deviation exceeds this fraction of the rise along an edge.
/// Below that, dividing the edge costs less.
constexpr double kRough = 0.3;
/// The number of successive smaller nodes that may improve the bound by less than kImproved: the
/// improvement may need a subdivision along another direction.
constexpr int kMaxIdle = 4;
constexpr double kImproved = 0.75;
/// The cost of an expansion about a node without evaluations of functions, in nanoseconds.
constexpr std::int64_t kCostOfMeeting = 700;
} // namespace

EdgeBounds::EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element,
  const Field& field, int component, double rounding)
  : Functions(mesh, bounds, element, field, component, rounding)
  , Tree(Functions)
  , Frame(Functions.GetShape(), bounds)
  , Ends(EndsOf(Functions.GetShape(), {}))
{
}

EdgeBounds::EdgeBounds(const Mesh& mesh, const ElementBounds& bounds, int element)
  : Functions(mesh, bounds, element)
  , Tree(Functions)
  , Frame(Functions.GetShape(), bounds)
  , Ends(EndsOf(Functions.GetShape(), {}))
{
}

std::int64_t EdgeBounds::SampleCost(const LocatedPoint& point, EdgeWork* work) const
{
  return Functions.SampleCost(Functions.IsKnown() && Tree.LeafAt(point.eta, work).regular);
}

std::array<double, 3> EdgeBounds::ShiftOf(
  const EdgeNode& node, std::span<const LocatedPoint> points) const
{
  const std::array<double, 3> most{ node.shift[0], node.shift[1], node.shift[2] };
  if (std::ranges::all_of(most, [](double shift) { return shift <= kMaxAssumed; }))
  {
    return most;
  }
  double off[3] = {};
  for (const LocatedPoint& point : points)
  {
    const PointValues image = Functions.ImagesAt(std::span(&point.xi, 1));
    const Vec3 y = Functions.InUnits(point.x);
    const Vec3 rounding = Functions.RoundingInUnits(point.x);
    double own[3] = {};
    for (std::size_t c = 0; c < 3; ++c)
    {
      const int axis = static_cast<int>(c);
      const double miss =
        std::fabs(image.values[c][0] - y[axis]) * kUp + rounding[axis] + Functions.ImageError();
      for (std::size_t k = 0; k < 3; ++k)
      {
        own[k] += std::fabs(node.inverse[k][c]) * miss;
      }
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      off[k] = std::max(off[k], own[k]);
    }
  }
  Solve(node.solution, off);
  std::array<double, 3> shift;
  for (std::size_t k = 0; k < 3; ++k)
  {
    // The comparison is written so that a NaN keeps the known bound.
    shift[k] = off[k] < most[k] ? off[k] : most[k];
  }
  return shift;
}

std::optional<EdgeRange> EdgeBounds::Along(const LocatedPoint& a, const LocatedPoint& b,
  double sagitta, EdgeWork* work, const ValueSet* wanted) const
{
  if (!Functions.IsKnown())
  {
    return std::nullopt;
  }
  // In a thin element a small node may give a bound where a large one gives none.
  for (const bool straight : { false, true })
  {
    const EdgeNode* node = &Tree.LeafAt(a.eta, work, straight);
    if (!node->regular || !node->wide.Holds(b.eta))
    {
      node = &Tree.LeafAt(b.eta, work, straight);
    }
    if (!node->regular || !node->wide.Holds(a.eta) || !node->wide.Holds(b.eta))
    {
      continue;
    }
    std::optional<EdgeRange> range = AlongIn(*node, a, b, sagitta);
    if (range && wanted != nullptr)
    {
      range = AlongSmaller(*node, *range, a, b, sagitta, work, *wanted);
    }
    if (range || node->straight)
    {
      return range;
    }
  }
  return std::nullopt;
}

EdgeRange EdgeBounds::AlongSmaller(const EdgeNode& node, const EdgeRange& found,
  const LocatedPoint& a, const LocatedPoint& b, double sagitta, EdgeWork* work,
  const ValueSet& wanted) const
{
  const auto [lower, upper] = std::minmax(a.value, b.value);
  const std::array etas{ a.eta, b.eta };
  EdgeRange range = found;
  const EdgeNode* at = &node;
  int idle = 0;
  // Smaller nodes may exclude the values, unless they lie between the ends' or stay within the rest
  // of the deviation.
  const auto mayHelp = [&, least = lower, most = upper]
  {
    const double rest = range.deviation - range.loose;
    return wanted.Meets(least - range.deviation, most + range.deviation) &&
      !wanted.Meets(least - rest, most + rest);
  };
  while (idle < kMaxIdle && range.loose > kLoose * range.deviation &&
    range.deviation > kRough * (upper - lower) && mayHelp())
  {
    at = Tree.SmallerWith(*at, etas, work);
    const std::optional<EdgeRange> smaller =
      at != nullptr ? AlongIn(*at, a, b, sagitta) : std::nullopt;
    if (!smaller)
    {
      break;
    }
    idle = smaller->deviation < kImproved * range.deviation ? 0 : idle + 1;
    range = smaller->deviation < range.deviation ? *smaller : range;
  }
  return range;
}

double EdgeBounds::CurvedAlong(const EdgeNode& node, const LocatedPoint& a, const double (&s)[3],
  const std::array<double, 3>& shift) const
{
  const double curved = Quadratic(node.curve, s) / 8.0;
  if (!Functions.HasJet() || !node.slopes)
  {
    return curved;
  }
  LocalCurves local(node, a.xi);
  // Reach takes the mean of a Taylor remainder, a third of the largest change.
  local.Reach({ 3.0 * (s[0] + 2.0 * shift[0]), 3.0 * (s[1] + 2.0 * shift[1]),
    3.0 * (s[2] + 2.0 * shift[2]) });
  const auto largest = [&s](const double(&form)[6], const double(&beside)[6])
  {
    double all[6];
    for (std::size_t p = 0; p < 6; ++p)
    {
      all[p] = std::fabs(form[p]) + beside[p];
    }
    return Quadratic(all, s) / 8.0;
  };
  double bent[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    bent[k] = largest(local.bend[k], local.bends[k]);
  }
  Solve(node.solution, bent);
  const double own = largest(local.curve, local.curves) + node.slope[0] * bent[0] +
    node.slope[1] * bent[1] + node.slope[2] * bent[2];
  // The comparison is written so that a NaN keeps the known bound.
  return own < curved ? own * kUp : curved;
}

std::optional<EdgeRange> EdgeBounds::AlongIn(
  const EdgeNode& node, const LocatedPoint& a, const LocatedPoint& b, double sagitta) const
{
  const LocatedPoint ends[2] = { a, b };
  const std::array<double, 3> shift = ShiftOf(node, ends);
  const double error = node.valueError;
  const double s[3] = { std::fabs(a.xi.x - b.xi.x), std::fabs(a.xi.y - b.xi.y),
    std::fabs(a.xi.z - b.xi.z) };
  double off[3];
  double beside[3];
  EdgeRange range{ .deviation = CurvedAlong(node, a, s, shift), .error = error };
  double outside = 0.0; // what the path may do beside the element
  bool mayLeave = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double besides = shift[k] + node.lean[k] * sagitta / Functions.Size();
    off[k] = (Quadratic(node.bend[k], s) / 8.0 + besides) * kUp;
    beside[k] = kBeside + 2.0 * shift[k];
    range.error += node.slope[k] * shift[k];
    range.deviation += node.slope[k] * besides;
    outside += node.slope[k] * 2.0 * beside[k];
    // A function that is no polynomial differs from its chord by at most half of the change along
    // it.
    range.loose += node.beside[k] * (0.5 * s[k] + off[k] + 2.0 * shift[k]);
  }
  for (const EdgeNodeEnd& end : node.wideEnds)
  {
    const double depth = std::min(end.DepthOf(a.xi), end.DepthOf(b.xi)) - end.Across(off);
    // The comparison is written so that a NaN is not covered.
    if (!(depth + (end.ofElement ? end.Across(beside) : 0.0) >= 0.0))
    {
      return std::nullopt;
    }
    mayLeave = mayLeave || depth < 0.0;
  }
  range.deviation += mayLeave ? outside : 0.0;
  if (Functions.Components() > 1)
  {
    // The norm of a vector that changes linearly, by at most `change`, is convex, and its second
    // derivative is at most the square of the change over the norm.
    double change = 2.0 * error;
    for (std::size_t k = 0; k < 3; ++k)
    {
      change += node.slope[k] * (s[k] + 2.0 * shift[k]);
    }
    const double least = std::max(a.value, b.value) - change;
    range.deviation += least > 0.25 * change ? change * change / (8.0 * least) : 0.5 * change;
  }
  range.deviation = (range.deviation + range.loose + error) * kUp;
  if (Functions.HasJet())
  {
    range.loose += Quadratic(node.rough, s) / 8.0;
  }
  range.error *= kUp;
  return range;
}

EdgeMeeting EdgeBounds::MeetNode(const EdgeNode& node, const WideOutline& region,
  const ValueSet& wanted, EdgeWork* work, KeptExpansion& kept) const
{
  if (work)
  {
    work->Spend(kCostOfMeeting + (kept.jet ? 0 : 2 * Functions.ViewCost()));
  }
  return Meet(Functions, node, region, wanted, nullptr, &kept);
}

std::optional<Interval> EdgeBounds::ValuesIn(
  const WideOutline& region, const ValueSet& wanted, const EdgeEffort& effort) const
{
  if (!Functions.IsKnown())
  {
    return Interval::Everything();
  }
  KeptExpansion kept;
  return Frame.Misses(Functions, region) ? std::nullopt
                                         : ValuesIn(Tree.Whole(), region, wanted, effort, kept);
}

std::optional<Interval> EdgeBounds::ValuesIn(const EdgeNode& node, const WideOutline& region,
  const ValueSet& wanted, const EdgeEffort& effort, KeptExpansion& kept) const
{
  const auto meets = [&wanted](const std::optional<Interval>& values)
  { return values && wanted.Meets(values->lower, values->upper); };
  if (effort.work)
  {
    effort.work->Spend(kCostOfLook);
  }
  if (Misses(Functions, node, region))
  {
    return std::nullopt;
  }
  std::optional<Interval> values = node.values;
  bool divide = !node.straight;
  if (node.regular && meets(values))
  {
    const EdgeMeeting meeting = MeetNode(node, region, wanted, effort.work, kept);
    values = meeting.values;
    divide = divide || (meeting.bends && node.subdivisions < effort.whereMapBends) ||
      (meeting.curves && node.subdivisions < effort.whereFieldCurves);
  }
  if (!divide || !meets(values) || !Tree.CanSplit(node, effort.work))
  {
    return values;
  }
  values.reset();
  for (const EdgeNode& half : Tree.Split(node))
  {
    const std::optional<Interval> own = ValuesIn(half, region, wanted, effort, kept);
    values = values && own ? Join(*values, *own) : (own ? own : values);
    if (meets(values))
    {
      break;
    }
  }
  return values;
}

bool EdgeBounds::MayTake(
  const ValueSet& wanted, const WideOutline& region, const EdgeEffort& effort) const
{
  if (!Functions.IsKnown())
  {
    return true;
  }
  KeptExpansion kept;
  // Works as ValuesIn, but tests a node's own values first, because that costs least.
  const auto mayTake = [&](const auto& self, const EdgeNode& node) -> bool
  {
    if (effort.work)
    {
      effort.work->Spend(kCostOfLook);
    }
    if (!wanted.Meets(node.values.lower, node.values.upper) || Misses(Functions, node, region))
    {
      return false;
    }
    bool divide = !node.straight;
    if (node.regular)
    {
      const EdgeMeeting meeting = MeetNode(node, region, wanted, effort.work, kept);
      if (!meeting.values || !wanted.Meets(meeting.values->lower, meeting.values->upper))
      {
        return false;
      }
      divide = divide || (meeting.bends && node.subdivisions < effort.whereMapBends) ||
        (meeting.curves && node.subdivisions < effort.whereFieldCurves);
    }
    return !divide || !Tree.CanSplit(node, effort.work) ||
      std::ranges::any_of(Tree.Split(node), [&](const EdgeNode& half) { return self(self, half); });
  };
  return !Frame.Misses(Functions, region) && mayTake(mayTake, Tree.Whole());
}

double EdgeBounds::ChangeWithin(const LocatedPoint& point, double distance, EdgeWork* work) const
{
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  if (!Functions.IsKnown())
  {
    return kUnknown;
  }
  const EdgeNode& node = Tree.LeafAt(point.eta, work);
  if (!node.regular)
  {
    return kUnknown;
  }
  const std::array<double, 3> shift = ShiftOf(node, std::span(&point, 1));
  double change = node.valueError;
  for (std::size_t k = 0; k < 3; ++k)
  {
    change += node.slope[k] * (node.lean[k] * (distance / Functions.Size()) + shift[k]);
  }
  return change * kUp;
}
} // namespace pixelexact
