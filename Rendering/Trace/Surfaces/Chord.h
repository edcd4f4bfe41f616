// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <cmath>
#include <limits>

namespace pixelexact
{
/// The straight line between a point of one ray of an image and a point of another, and the rays
/// between the two. These rays lie in a plane with the chord, each crosses it, and their directions
/// lie between those of the two.
struct Chord
{
  Ray a;
  Vec3 from; ///< on a
  Ray b;
  Vec3 to; ///< on b
  /// Distance from the chord, along the rays, that is searched; in lengths of the chord.
  double room = 0.5;

  [[nodiscard]] Vec3 Along() const { return to - from; }
  [[nodiscard]] double Length() const;
  [[nodiscard]] Vec3 Middle() const { return 0.5 * from + 0.5 * to; }
  /// Largest distance of a direction from a's.
  [[nodiscard]] double Turn() const;
  [[nodiscard]] double Room() const { return room * Length(); }
  /// Radius of a ball about the middle that contains the chord and the searched room.
  [[nodiscard]] double Radius() const { return Room() + 0.5 * Length() + Slack(); }
  /// Largest distance at which rays pass the chord, by rounding of rays and points.
  [[nodiscard]] double Slack() const;
};

/// Reach of a surface that is the zero set of a function f. |f| <= `value` on the chord and where
/// rays pass it. In the ball about the chord's middle, f's derivative along the rays has the sign
/// of `slope` and is at least |slope| - change in magnitude. So each ray meets at most one zero
/// within the chord's room. It meets one if |f| over the least slope is less than the room, and
/// that quotient bounds the zero's distance. The zero is a continuous function of the ray, because
/// it is unique. Infinite if the bounds do not prove this.
[[nodiscard]] double ReachBySlope(const Chord& chord, double value, double slope, double change);
/// Reach of a plane.
[[nodiscard]] double ReachOfPlane(const Chord& chord, const Vec3& point, const Vec3& unitNormal);

/// The first finite result of reach(chord), for increasing room. Steep creases need more room;
/// bounds of slopes are tighter with less.
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
