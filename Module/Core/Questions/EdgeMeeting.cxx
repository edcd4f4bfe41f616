// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/EdgeMeeting.h"

#include "Core/Math/Rounding.h"
#include "Core/Questions/EdgeArithmetic.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
using namespace edges;

namespace
{
/// What the expansion's error may be of the distance.
constexpr double kCoarse = 0.25;
constexpr int kRounds = 6;
/// Of Newton's iteration towards an edge's middle.
constexpr int kSteps = 2;
/// Covers the rounding of sums of some five products, of their magnitudes' sum.
constexpr double kSum = 8.0 * kUnitRoundoff;

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

/// By the affine map of a node.
Vec3 ToXi(const EdgeFunctions& functions, const EdgeNode& node, const Vec3& x)
{
  const Vec3 y = functions.InUnits(x) - node.origin;
  Vec3 xi = node.centre;
  for (int k = 0; k < 3; ++k)
  {
    const double(&row)[3] = node.inverse[k];
    xi[k] += row[0] * y.x + row[1] * y.y + row[2] * y.z;
  }
  return xi;
}
} // namespace

bool Misses(const EdgeFunctions& functions, const EdgeNode& node, const WideEdge& edge)
{
  const auto& [from, to, slack] = edge;
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
  const Vec3 ends[2] = { ToXi(functions, node, from), ToXi(functions, node, to) };
  const double most = std::max({ node.reach[0], node.reach[1], node.reach[2] });
  const double inY = slack / functions.Size() + functions.ImageError() +
    kSum *
      (std::max(LargestOf(functions.InUnits(from)), LargestOf(functions.InUnits(to))) +
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

EdgeMeeting Meet(const EdgeFunctions& functions, const EdgeNode& node, const ValueSet& wanted,
  const WideEdge& edge)
{
  const auto& [from, to, slack] = edge;
  const Shape shape = functions.GetShape();
  const Vec3 ends[2] = { functions.InUnits(from), functions.InUnits(to) };
  const Vec3 middle = 0.5 * (ends[0] + ends[1]);
  EdgeFunctions::View view =
    functions.ViewAt(MovedInto(shape, node, ToXi(functions, node, 0.5 * (from + to))));
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
    view = functions.ViewAt(next);
  }

  // |xi - view.xi| of the preimages in `wide` of the segment's points.
  const double inY = slack / functions.Size() + functions.ImageError() +
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
        functions.ImageSlopeError() * SumOf(step));
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
      return EdgeMeeting::None;
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
    return EdgeMeeting::None;
  }
  const Interval linear = functions.LinearValues(
    view.xi, steps[0] + first * (steps[1] - steps[0]), steps[0] + last * (steps[1] - steps[0]));
  double most = Quadratic(node.curve, away) / 2.0 + 2.0 * functions.ValueError();
  for (std::size_t k = 0; k < 3; ++k)
  {
    most += node.slope[k] * besides[k];
  }
  most = most * kUp + 1e-14 * (std::fabs(linear.lower) + std::fabs(linear.upper));
  if (!wanted.Meets(rounding::Below(linear.lower - most), rounding::Above(linear.upper + most)))
  {
    return EdgeMeeting::None;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (off[k] > kCoarse * away[k] + 2.0 * besides[k])
    {
      return EdgeMeeting::Coarse;
    }
  }
  return EdgeMeeting::Near;
}
} // namespace pixelexact
