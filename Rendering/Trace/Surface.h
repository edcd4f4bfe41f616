// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"

#include <limits>
#include <span>

namespace pixelexact
{
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// A cut-surface: where rays meet it (paper, section 5.1.1). One file each.
class Surface
{
public:
  virtual ~Surface() = default;

  /// For each ray the smallest t > tMin[i] at which it meets the surface, kNoHit where there is
  /// none. `position[i]` is the point of the surface there, on ray and surface up to rounding.
  virtual void NextHit(std::span<const Ray> rays, std::span<const double> tMin, std::span<double> t,
    std::span<Vec3> position) const = 0;

  /// The unit normal at a point of the surface.
  [[nodiscard]] virtual Vec3 Normal(const Vec3& position) const = 0;
};
} // namespace pixelexact
