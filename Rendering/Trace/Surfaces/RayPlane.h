// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Chord.h"

namespace pixelexact
{
/// The plane in which the rays of a chord lie: where a surface made of pieces is followed from one
/// end to the other, piece by piece.
class RayPlane
{
public:
  explicit RayPlane(const Chord& chord);

  /// Whether the rays are so far from the chord's direction that they span a plane with it, and all
  /// of them pass it in the same direction.
  [[nodiscard]] bool IsKnown() const { return Known; }
  /// Of a point over it.
  [[nodiscard]] double Height(const Vec3& x) const;
  /// How far off that may be, by rounding of the chord and the rays.
  [[nodiscard]] double Uncertainty(const Vec3& x) const;
  /// The nearest point of the plane.
  [[nodiscard]] Vec3 Onto(const Vec3& x) const { return x - Height(x) * Normal; }
  /// How far a step leads across the rays, at least: above 0 it leads from rays to such as are
  /// nearer to b, wherever between the two it is.
  [[nodiscard]] double Progress(const Vec3& from, const Vec3& to) const;
  /// How far a point of the plane is from the chord, at most, along any direction between the two.
  [[nodiscard]] double OffChord(const Vec3& x) const;

private:
  Vec3 Start;
  double Length;
  double Slack;
  Vec3 Normal{ 0.0 };
  Vec3 Across{ 0.0 };     ///< of unit length, in the plane, perpendicular to the chord
  Vec3 Forward[2]{};      ///< in the plane, perpendicular to the rays' directions, towards b
  double LeastSine = 0.0; ///< of the angle between chord and rays
  bool Known = false;
};
} // namespace pixelexact
