// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/FoundRoots.h"
#include "Core/Tree/NodeFrame.h"

#include <cstdint>
#include <span>

namespace pixelexact
{
/// A group's points: as they were given, and in the element's units.
struct PointGroup
{
  [[nodiscard]] Vec3 YOf(std::size_t point) const
  {
    return { y.x[0][point], y.x[1][point], y.x[2][point] };
  }

  std::span<const SoughtPoint> points;
  GroupLanes y;
};

/// What Newton's iteration for so many points costs (PointSearch.h: kMaxWork).
std::int64_t NewtonCost(const Space& space, int points);

/// Newton's iteration for the points in `bits`, from the frame's guesses; the roots are added to
/// `roots`. Of which points it found one.
Bits RunNewton(const InverseProblem& problem, RootChecker& checker, const NodeFrame& frame,
  const PointGroup& group, Bits bits, FoundRoots& roots);
} // namespace pixelexact
