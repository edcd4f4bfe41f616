// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeBounds.h"

#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
using namespace edges;

namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// By how much a path may leave the element, in xi: far less than would be seen, and more than
/// rounding makes of an edge in a face.
constexpr double kBeside = 1e-13;
/// What the expansion's error may be of the distance.
constexpr double kCoarse = 0.25;
constexpr int kRounds = 6;
/// Of Newton's iteration towards a segment's middle.
constexpr int kSteps = 2;
/// Covers the rounding of sums of some five products, of their magnitudes' sum.
constexpr double kSum = 8.0 * kUnitRoundoff;

double LargestOf(const Vec3& a)
{
  return std::max({ std::fabs(a.x), std::fabs(a.y), std::fabs(a.z) });
}

double SumOf(const Vec3& a)
{
  return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
}

/// A xi of a box, not far from the nearest one.
Vec3 MovedInto(Shape shape, const EdgeNode& node, const Vec3& xi)
{
  const EtaBox& box = node.wide;
  Vec3 moved = xi;
  for (int round = 0; round < 3; ++round)
  {
    for (const EdgeNodeEnd& end : node.wideEnds)
    {
      const double depth = end.DepthOf(moved);
      if (depth < 0.0)
      {
        const Vec3 normal(end.normal[0], end.normal[1], end.normal[2]);
        moved += normal * (depth / glm::dot(normal, normal));
      }
    }
  }
  // What is left, in eta: of a NaN, any point.
  return TensorToReference(
    shape, glm::clamp(ReferenceToTensor(shape, moved), box.lower, box.upper));
}

bool Holds(const EtaBox& box, const Vec3& eta)
{
  return Box3{ box.lower, box.upper }.Contains(eta);
}
} // namespace

bool ValueSet::Meets(double from, double to) const
{
  const auto at = std::ranges::lower_bound(values, from);
  return from <= lower || to >= upper || (at != values.end() && *at <= to);
}

/// The map at a point.
struct EdgeBounds::View
{
  Vec3 xi;
  Vec3 y;
  Mat3 jacobian;
  Mat3 inverse; ///< of J, as rounding leaves it
};

namespace
{
/// Room for one point's lanes.
constexpr std::size_t kRoom = 16;

/// `components` functions and their derivatives by xi at a point: values, then slopes, of
/// `components` times 3.
struct Evaluated
{
  double values[3][kRoom];
  double slopes[9][kRoom];

  Evaluated(const Space& space, const double* modes, int components, const Vec3& xi)
  {
    double at[3][kRoom];
    for (int d = 0; d < 3; ++d)
    {
      std::fill_n(at[d], kRoom, xi[d]);
    }
    double* const out[3] = { values[0], values[1], values[2] };
    double* gradient[9];
    for (std::size_t k = 0; k < 9; ++k)
    {
      gradient[k] = slopes[k];
    }
    KernelsFor(space).gradient(
      space, modes, components, { { at[0], at[1], at[2] }, 1 }, out, gradient);
  }
};
} // namespace

EdgeBounds::View EdgeBounds::ViewAt(const Vec3& xi) const
{
  const Evaluated map(Map.space, Map.values.data(), 3, xi);
  const double scale = std::ldexp(1.0, Map.exponent);
  View view{ xi, Vec3(0.0), Mat3(0.0), Mat3(0.0) };
  for (int c = 0; c < 3; ++c)
  {
    view.y[c] = scale * map.values[c][0];
    for (int j = 0; j < 3; ++j)
    {
      view.jacobian[j][c] = scale * map.slopes[3 * c + j][0];
    }
  }
  view.inverse = glm::inverse(view.jacobian);
  return view;
}

Vec3 EdgeBounds::ImageOf(const Vec3& xi) const
{
  return ViewAt(xi).y;
}

std::optional<EdgeRange> EdgeBounds::Along(
  const LocatedPoint& a, const LocatedPoint& b, double sagitta) const
{
  if (!Component.finite)
  {
    return std::nullopt;
  }
  const EdgeNode* node = &LeafAt(a.eta);
  if (!node->regular || !Holds(node->wide, b.eta))
  {
    node = &LeafAt(b.eta);
    if (!node->regular || !Holds(node->wide, a.eta))
    {
      return std::nullopt;
    }
  }
  const double s[3] = { std::fabs(a.xi.x - b.xi.x), std::fabs(a.xi.y - b.xi.y),
    std::fabs(a.xi.z - b.xi.z) };
  double off[3];
  double beside[3];
  EdgeRange range{ Quadratic(node->curve, s) / 8.0, ValueError };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double besides = node->shift[k] + node->lean[k] * sagitta / Size;
    off[k] = (Quadratic(node->bend[k], s) / 8.0 + besides) * kUp;
    beside[k] = kBeside + 2.0 * node->shift[k];
    range.error += node->slope[k] * node->shift[k];
    range.deviation += node->slope[k] * (besides + 2.0 * beside[k]);
  }
  for (const EdgeNodeEnd& end : node->wideEnds)
  {
    const double depth = std::min(end.DepthOf(a.xi), end.DepthOf(b.xi)) - end.Across(off) +
      (end.ofElement ? end.Across(beside) : 0.0);
    // Written so that a NaN is not covered.
    if (!(depth >= 0.0))
    {
      return std::nullopt;
    }
  }
  if (Components > 1)
  {
    // Of the norm of a vector that changes linearly, by at most `change`: it is convex, and its
    // second derivative is at most the change's square over the norm.
    double change = 2.0 * ValueError;
    for (std::size_t k = 0; k < 3; ++k)
    {
      change += node->slope[k] * (s[k] + 2.0 * node->shift[k]);
    }
    const double least = std::max(a.value, b.value) - change;
    range.deviation += least > 0.25 * change ? change * change / (8.0 * least) : 0.5 * change;
  }
  range.deviation = (range.deviation + ValueError) * kUp;
  range.error *= kUp;
  return range;
}

bool EdgeBounds::Misses(const EdgeNode& node, const Vec3& from, const Vec3& to, double slack) const
{
  for (int d = 0; d < 3; ++d)
  {
    if (std::max(from[d], to[d]) + slack < node.bounds.lower[d] ||
      std::min(from[d], to[d]) - slack > node.bounds.upper[d])
    {
      return true;
    }
  }
  if (!node.regular)
  {
    return false;
  }
  // Every preimage in `wide` of a point of the segment is within `off` of the line between these
  // two: T(xi) = M (Phi(xi) - origin) - (xi - centre) changes by `turn` at most.
  const Vec3 ends[2] = { ToXi(node, from), ToXi(node, to) };
  const double most = std::max({ node.reach[0], node.reach[1], node.reach[2] });
  const double inY = slack / Size + ImageError +
    kSum *
      (std::max(LargestOf((from - Centre) / Size), LargestOf((to - Centre) / Size)) +
        LargestOf(node.origin));
  double off[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    off[k] = (node.turn[k] * most + node.shift[k] + node.lean[k] * inY) * kUp + 1e-13;
  }
  double first = 0.0;
  double last = 1.0;
  for (const EdgeNodeEnd& end : node.boxEnds)
  {
    const double wider = end.Across(off);
    const double a = end.DepthOf(ends[0]) + wider;
    const double b = end.DepthOf(ends[1]) + wider;
    if (a < 0.0 && b < 0.0)
    {
      return true;
    }
    if (a < 0.0)
    {
      first = std::max(first, a / (a - b));
    }
    if (b < 0.0)
    {
      last = std::min(last, a / (a - b));
    }
  }
  return first > last + 1e-12;
}

Vec3 EdgeBounds::ToXi(const EdgeNode& node, const Vec3& x) const
{
  const Vec3 y = (x - Centre) / Size - node.origin;
  Vec3 xi = node.centre;
  for (int k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    xi[k] += row[0] * y.x + row[1] * y.y + row[2] * y.z;
  }
  return xi;
}

/// In a regular node, from the second-order expansion about a point of it near the segment.
EdgeBounds::Meeting EdgeBounds::MeetNode(const EdgeNode& node, const ValueSet& wanted,
  const Vec3& from, const Vec3& to, double slack) const
{
  const Shape shape = Map.space.shape;
  const Vec3 ends[2] = { (from - Centre) / Size, (to - Centre) / Size };
  const Vec3 middle = 0.5 * (ends[0] + ends[1]);
  View view = ViewAt(MovedInto(shape, node, ToXi(node, 0.5 * (from + to))));
  for (int step = 0; step < kSteps; ++step)
  {
    const Vec3 half = 0.5 * (view.inverse * (ends[1] - ends[0]));
    const Vec3 next = MovedInto(shape, node, view.xi + view.inverse * (middle - view.y));
    const Vec3 moved = next - view.xi;
    // Written so that a NaN ends it.
    if (!(glm::dot(moved, moved) > glm::dot(half, half)))
    {
      break;
    }
    view = ViewAt(next);
  }

  // |xi - view.xi| of the preimages in `wide` of the segment's points.
  const double inY = slack / Size + ImageError +
    kSum * std::max({ LargestOf(ends[0]), LargestOf(ends[1]), LargestOf(view.y) });
  double away[3];
  double besides[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    const auto along = [&](const Vec3& y)
    {
      const Vec3 d = y - view.y;
      return std::fabs(row[0] * d.x + row[1] * d.y + row[2] * d.z);
    };
    besides[k] = node.shift[k] + node.lean[k] * inY + 1e-14;
    away[k] = std::max(along(ends[0]), along(ends[1])) * kUp + besides[k];
  }
  Solve(node.turn, away);
  const Vec3 steps[2] = { view.inverse * (ends[0] - view.y), view.inverse * (ends[1] - view.y) };
  // What the computed Jacobian and its inverse leave of the steps' equations, in y.
  double left = 0.0;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Vec3& step = steps[k];
    const Vec3 magnitudes = LargestOf(step) *
      (glm::abs(view.jacobian[0]) + glm::abs(view.jacobian[1]) + glm::abs(view.jacobian[2]));
    left = std::max(left,
      LargestOf(ends[k] - view.y - view.jacobian * step) + kSum * LargestOf(magnitudes) +
        ImageSlopeError * SumOf(step));
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    besides[k] += node.lean[k] * left;
  }
  // They are where the expansion puts them, up to `off`, and so no farther away than that.
  double off[3];
  for (int round = 0; round < kRounds; ++round)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      off[k] = (Quadratic(node.bend[k], away) / 2.0 + besides[k]) * kUp;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int d = static_cast<int>(k);
      away[k] = std::min(
        away[k], (std::max(std::fabs(steps[0][d]), std::fabs(steps[1][d])) + off[k]) * kUp);
    }
  }
  double first = 0.0;
  double last = 1.0;
  for (const EdgeNodeEnd& end : node.boxEnds)
  {
    const double wider = end.Across(off);
    const double a = end.DepthOf(view.xi + steps[0]) + wider;
    const double b = end.DepthOf(view.xi + steps[1]) + wider;
    if (a < 0.0 && b < 0.0)
    {
      return Meeting::None;
    }
    if (a < 0.0)
    {
      first = std::max(first, a / (a - b) - 1e-12);
    }
    if (b < 0.0)
    {
      last = std::min(last, a / (a - b) + 1e-12);
    }
  }
  if (first > last)
  {
    return Meeting::None;
  }
  const Interval linear = LinearValues(
    view.xi, steps[0] + first * (steps[1] - steps[0]), steps[0] + last * (steps[1] - steps[0]));
  double most = Quadratic(node.curve, away) / 2.0 + 2.0 * ValueError;
  for (std::size_t k = 0; k < 3; ++k)
  {
    most += node.slope[k] * besides[k];
  }
  most = most * kUp + 1e-14 * (std::fabs(linear.lower) + std::fabs(linear.upper));
  if (!wanted.Meets(rounding::Below(linear.lower - most), rounding::Above(linear.upper + most)))
  {
    return Meeting::None;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (off[k] > kCoarse * away[k] + 2.0 * besides[k])
    {
      return Meeting::Coarse;
    }
  }
  return Meeting::Near;
}

Interval EdgeBounds::LinearValues(const Vec3& xi, const Vec3& from, const Vec3& to) const
{
  const double unit = std::ldexp(1.0, Component.exponent);
  const auto width = static_cast<std::ptrdiff_t>(Component.width);
  // Of all components: the values at both ends, and their squares and product.
  double ends[2] = {};
  double squares[2] = {};
  double product = 0.0;
  double size = 0.0;
  double slack = ValueSlopeError * std::max(SumOf(from), SumOf(to));
  for (int c = 0; c < Components; ++c)
  {
    const Evaluated component(Component.space, Component.values.data() + c * width, 1, xi);
    const Vec3 slope(component.slopes[0][0], component.slopes[1][0], component.slopes[2][0]);
    const double rises[2] = { glm::dot(slope, from), glm::dot(slope, to) };
    for (std::size_t k = 0; k < 2; ++k)
    {
      ends[k] = unit * (component.values[0][0] + rises[k]);
      squares[k] += ends[k] * ends[k];
    }
    product += ends[0] * ends[1];
    size += unit *
      (std::fabs(component.values[0][0]) + LargestOf(slope) * std::max(SumOf(from), SumOf(to)));
  }
  slack += 1e-14 * size;
  if (Components == 1)
  {
    return { std::min(ends[0], ends[1]) - slack, std::max(ends[0], ends[1]) + slack };
  }
  // |p + t (q - p)|: convex, least where (p + t (q - p)) . (q - p) = 0.
  const double along = squares[0] + squares[1] - 2.0 * product;
  const double t = along > 0.0 ? std::clamp((squares[0] - product) / along, 0.0, 1.0) : 0.0;
  const double least = squares[0] - 2.0 * t * (squares[0] - product) + t * t * along;
  return { std::sqrt(std::max(0.0, least - slack * size)) - slack,
    std::sqrt(std::max(squares[0], squares[1])) + slack };
}

bool EdgeBounds::MayTake(
  const ValueSet& wanted, const Vec3& from, const Vec3& to, double slack, bool grow) const
{
  return !Component.finite || MayTakeIn(Whole(), wanted, from, to, slack, grow);
}

bool EdgeBounds::MayTakeIn(const EdgeNode& node, const ValueSet& wanted, const Vec3& from,
  const Vec3& to, double slack, bool grow) const
{
  if (!wanted.Meets(node.values.lower, node.values.upper) || Misses(node, from, to, slack))
  {
    return false;
  }
  const Meeting meeting = node.regular ? MeetNode(node, wanted, from, to, slack) : Meeting::Coarse;
  if (meeting != Meeting::Coarse)
  {
    return meeting == Meeting::Near;
  }
  if (node.halvings >= Deepest[node.regular ? 1 : 0] || (!grow && node.regular))
  {
    return true;
  }
  const auto& halves = Split(node);
  return std::ranges::any_of(
    halves, [&](const EdgeNode& half) { return MayTakeIn(half, wanted, from, to, slack, grow); });
}

double EdgeBounds::ChangeWithin(const LocatedPoint& point, double distance) const
{
  if (!Component.finite)
  {
    return kInfinity;
  }
  const EdgeNode& node = LeafAt(point.eta);
  if (!node.regular)
  {
    return kInfinity;
  }
  double change = ValueError;
  for (std::size_t k = 0; k < 3; ++k)
  {
    change += node.slope[k] * (node.lean[k] * (distance / Size) + node.shift[k]);
  }
  return change * kUp;
}
} // namespace pixelexact
