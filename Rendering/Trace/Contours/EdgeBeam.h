// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/Outline.h"
#include "Trace/Camera.h"

namespace pixelexact
{
/// All that rays between two of an image may meet in a box: a flat strip, in parts by depth.
class EdgeBeam
{
public:
  EdgeBeam(const Ray& a, const Ray& b, const Box3& box);

  // Along the rays: what is beyond is outside of the box. `Nearest` is greater where all is.
  [[nodiscard]] double Nearest() const { return Near; }
  [[nodiscard]] double Farthest() const { return Far; }
  /// Holds all of the strip from one depth to the next.
  [[nodiscard]] Outline Part(double from, double to) const;
  /// How far its corners may be off, by the rounding of rays.
  [[nodiscard]] double Slack() const { return Rounding; }

private:
  Ray A;
  Ray B;
  double Near;
  double Far;
  double Rounding;
};
} // namespace pixelexact
