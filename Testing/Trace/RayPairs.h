// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ChordCheck.h"

// Neighbouring rays at given places, and the distance of a surface from their chord along them.
namespace pixelexact::testing
{
/// The distance of x from the line through both points, along a direction nearly in their plane.
inline double DistanceAlong(const Vec3& from, const Vec3& to, const Vec3& direction, const Vec3& x)
{
  const Vec3 chord = glm::normalize(to - from);
  const Vec3 across = direction - glm::dot(direction, chord) * chord;
  const Vec3 off = x - from;
  return std::fabs(glm::dot(off, across)) / glm::dot(across, across);
}

/// The first of them to a place.
inline Pair PairTo(const Vec3& target, Random& random, double away, double apart, bool parallel)
{
  Pair pair(random, away, apart, parallel);
  pair.Eye += target - pair.Target;
  pair.Target = target;
  return pair;
}
} // namespace pixelexact::testing
