// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Chord.h"

namespace pixelexact
{
/// The plane of a chord's rays. Surfaces made of pieces are followed in it from one end to the
/// other, piece by piece.
class RayPlane
{
public:
  explicit RayPlane(const Chord& chord);

  /// The rays' directions differ enough from the chord's to span a plane with it, and all rays
  /// cross the chord in the same direction.
  [[nodiscard]] bool IsKnown() const { return Known; }
  /// Signed distance of a point from the plane.
  [[nodiscard]] double Height(const Vec3& x) const;
  /// Largest error of Height(x), by rounding of chord and rays.
  [[nodiscard]] double Uncertainty(const Vec3& x) const;
  /// The nearest point of the plane.
  [[nodiscard]] Vec3 Onto(const Vec3& x) const { return x - Height(x) * Normal; }
  /// Lower bound of a step's length across the rays. If positive, the step leads towards b's ray,
  /// anywhere between the two rays.
  [[nodiscard]] double Progress(const Vec3& from, const Vec3& to) const;
  /// Largest distance of a point of the plane from the chord, along any direction between the two
  /// rays'.
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
