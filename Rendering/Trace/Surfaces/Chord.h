// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <cmath>
#include <limits>

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
  /// How far from the chord along the rays is looked, in lengths of the chord.
  double room = 0.5;

  [[nodiscard]] Vec3 Along() const { return to - from; }
  [[nodiscard]] double Length() const;
  [[nodiscard]] Vec3 Middle() const { return 0.5 * from + 0.5 * to; }
  /// No direction is farther from a's.
  [[nodiscard]] double Turn() const;
  [[nodiscard]] double Room() const { return room * Length(); }
  /// Of a ball about the middle that holds the chord and what is looked at.
  [[nodiscard]] double Radius() const { return Room() + 0.5 * Length() + Slack(); }
  /// How far beside the chord rays may pass it, by the rounding of rays and points.
  [[nodiscard]] double Slack() const;
};

/// Of a function whose zeros are a surface: |f| <= `value` on the chord and where rays pass it, and
/// in the ball about the chord's middle its derivative along them has the sign of `slope` and is no
/// smaller than |slope| - change. Then each ray meets one zero at most within the chord's room, and
/// it does where |f| over the least slope is less than that: so far at most it is. Where, is a
/// continuous function of the ray, since there is only one. Infinite where the bounds do not prove
/// this.
[[nodiscard]] double ReachBySlope(const Chord& chord, double value, double slope, double change);
/// The same of a plane.
[[nodiscard]] double ReachOfPlane(const Chord& chord, const Vec3& point, const Vec3& unitNormal);

/// The first finite answer of reach(chord), with more and more room: creases that are steep for the
/// rays need it, and slopes are the better known the less there is.
template <class Reach>
[[nodiscard]] double ReachWithRoom(Chord chord, const Reach& reach)
{
  double found = std::numeric_limits<double>::infinity();
  for (const double room : { 0.0625, 0.5, 4.0, 32.0 })
  {
    chord.room = room;
    found = reach(chord);
    if (std::isfinite(found))
    {
      break;
    }
  }
  return found;
}
} // namespace pixelexact
