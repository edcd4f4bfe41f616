// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

namespace pixelexact
{
/// The straight line between a point of one ray of an image and a point of another, and the rays
/// between these two: they lie in a plane with it, each passes it, and their directions are between
/// those of the two.
struct Chord
{
  Ray a;
  Vec3 from; ///< on a
  Ray b;
  Vec3 to; ///< on b

  [[nodiscard]] Vec3 Along() const { return to - from; }
  [[nodiscard]] double Length() const;
  [[nodiscard]] Vec3 Middle() const { return 0.5 * from + 0.5 * to; }
  /// No direction is farther from a's.
  [[nodiscard]] double Turn() const;
  /// How far beside the chord rays may pass it, by the rounding of rays and points.
  [[nodiscard]] double Slack() const;
};

/// Of a function whose zeros are a surface: |f| <= `value` on the chord and where rays pass it, and
/// wherever they are no farther from the chord's middle than it is long, its derivative along them
/// has the sign of `slope` and is no smaller than |slope| - change. Then each ray meets one zero at
/// most within half the chord's length of the chord, and it does where |f| over the least slope is
/// less than that: so far at most it is. Where, is a continuous function of the ray, since there is
/// only one. Infinite where the bounds do not prove this.
[[nodiscard]] double ReachBySlope(const Chord& chord, double value, double slope, double change);
/// The same of a plane.
[[nodiscard]] double ReachOfPlane(const Chord& chord, const Vec3& point, const Vec3& unitNormal);
} // namespace pixelexact
