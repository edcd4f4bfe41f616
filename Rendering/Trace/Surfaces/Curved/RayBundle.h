// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Rays.h"

#include "Core/Math/Vec.h"

#include <array>
#include <limits>

namespace pixelexact
{
/// Neighbouring rays seen together: lines over one coordinate of space, along which all of them
/// run. Boxes are tested against all at once, by what their places and slopes have in common.
///
/// Ray i is x_a(z) = place[a][i] + slope[a][i] (z - z0), z its coordinate x[axes[2]] and a one of
/// the other two. Its depth is the distance from z0 along that coordinate, counted in the direction
/// of the rays.
class RayBundle
{
public:
  static constexpr int kMost = 128;

  /// Of `count` rays from number `first`, about a box: z0 lies in its middle. False where they do
  /// not run along one coordinate; one ray alone always does, unless it has no direction.
  bool Begin(const RayLanes& rays, int first, int count, const Box3& about);

  [[nodiscard]] int Count() const { return Size; }
  [[nodiscard]] int First() const { return Offset; }

  /// Whether a ray of them may meet the box; no ray that does is passed over.
  [[nodiscard]] bool MayMeet(const Box3& box) const;
  /// The same for ray i, within what is left of it.
  [[nodiscard]] bool MayMeet(const Box3& box, int i) const;
  /// No point of the box is nearer.
  [[nodiscard]] double DepthOf(const Box3& box) const;

  [[nodiscard]] double DepthAt(int i, double t) const;
  [[nodiscard]] double TimeAt(int i, const Vec3& x) const;
  /// The ray is of no interest beyond a depth.
  void EndAt(int i, double depth);
  /// Beyond it no ray is of interest.
  [[nodiscard]] double Farthest() const;

  std::array<int, 3> axes{};
  double z0 = 0.0;
  std::array<std::array<double, kMost>, 2> place;
  std::array<std::array<double, kMost>, 2> slope;

private:
  struct Range
  {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
  };

  int Size = 0;
  int Offset = 0;
  double Sign = 1.0;
  double Slack = 0.0; ///< of places, by rounding
  std::array<Range, 2> Places;
  std::array<Range, 2> Slopes;
  Range Depths;
  std::array<double, kMost> Near;
  std::array<double, kMost> Far;
  std::array<double, kMost> Origin;    ///< along axes[2], from z0
  std::array<double, kMost> Direction; ///< along axes[2]
};
} // namespace pixelexact
