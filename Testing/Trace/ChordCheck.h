// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

#include "Trace/Camera.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

// Chords between the hits of neighbouring rays.
namespace pixelexact::testing
{
/// How far x is from the segment.
inline double DistanceTo(const Vec3& from, const Vec3& to, const Vec3& x)
{
  const Vec3 along = to - from;
  const double s = std::clamp(glm::dot(x - from, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(x, from + s * along);
}

/// How far x is from the line through both, along a direction nearly in their plane.
inline double DistanceAlong(const Vec3& from, const Vec3& to, const Vec3& direction, const Vec3& x)
{
  const Vec3 chord = glm::normalize(to - from);
  const Vec3 across = direction - glm::dot(direction, chord) * chord;
  const Vec3 off = x - from;
  return std::fabs(glm::dot(off, across)) / glm::dot(across, across);
}

/// Two rays of a camera, near to each other.
struct RayPair
{
  /// To a place in a cube.
  RayPair(Random& random, double away, double apart, bool parallel)
    : RayPair(
        random, [](Random& of) { return 0.9 * Vec3(of(), of(), of()); }, away, apart, parallel)
  {
  }
  /// To target(random).
  template <class MakeTarget>
  RayPair(Random& random, const MakeTarget& target, double away, double apart, bool parallel)
  {
    const Vec3 forward = glm::normalize(Vec3(random(), random(), random()));
    const Vec3 aside = glm::normalize(glm::cross(forward, Vec3(random(), random(), random())));
    Target = target(random);
    Eye = Target - away * forward;
    Step = apart * aside;
    IsParallel = parallel;
  }
  /// 0 and 1: the two; between them, those of the image between.
  [[nodiscard]] Ray At(double s) const
  {
    const Vec3 to = Target + s * Step;
    return IsParallel ? Ray{ Eye + s * Step, glm::normalize(Target - Eye) }
                      : Ray{ Eye, glm::normalize(to - Eye) };
  }

  Vec3 Eye{ 0.0 };
  Vec3 Target{ 0.0 };
  Vec3 Step{ 0.0 };
  bool IsParallel = false;
};
} // namespace pixelexact::testing
