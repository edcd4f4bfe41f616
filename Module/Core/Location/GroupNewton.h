// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/FoundRoots.h"
#include "Core/Tree/NodeFrame.h"

#include <cstdint>
#include <span>

namespace pixelexact
{
/// A group's points, in world coordinates and in the element's units.
struct PointGroup
{
  [[nodiscard]] Vec3 YOf(std::size_t point) const
  {
    return { y.x[0][point], y.x[1][point], y.x[2][point] };
  }

  std::span<const SoughtPoint> points;
  GroupLanes y;
};

/// The cost of Newton's iteration for `points` points, in the units of kMaxWork (PointSearch.h).
std::int64_t NewtonCost(const Space& space, int points);

/// Runs Newton's iteration for the points in `bits`, from the frame's guesses, and adds the roots
/// to `roots`. Returns the points for which it found one.
Bits RunNewton(const InverseProblem& problem, RootChecker& checker, const NodeFrame& frame,
  const PointGroup& group, Bits bits, FoundRoots& roots);
} // namespace pixelexact
