// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/Outline.h"
#include "Trace/Camera.h"

namespace pixelexact
{
/// The flat strip between two rays of an image, clipped to a box and divided into parts by depth.
class EdgeBeam
{
public:
  EdgeBeam(const Ray& a, const Ray& b, const Box3& box);

  // Range of depths, distances along the rays, that covers the box. `Nearest` exceeds `Farthest` if
  // the strip does not meet the box.
  [[nodiscard]] double Nearest() const { return Near; }
  [[nodiscard]] double Farthest() const { return Far; }
  /// Contains all of the strip between two depths.
  [[nodiscard]] Outline Part(double from, double to) const;
  /// Largest error of a part's corners, from the rounding of rays, in world units.
  [[nodiscard]] double Slack() const { return Rounding; }

private:
  Ray A;
  Ray B;
  double Near;
  double Far;
  double Rounding;
};
} // namespace pixelexact
