// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Rays.h"

#include <limits>

namespace pixelexact
{
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// A cut-surface: where rays meet it (paper, section 5.1.1). One file each.
class Surface
{
public:
  virtual ~Surface() = default;

  /// For each ray the smallest t > tMin[i] at which it meets the surface, kNoHit where there is
  /// none. The position is the point of the surface there, on ray and surface up to rounding;
  /// anything where there is none. `tMin` and `hits` are padded as the rays are.
  virtual void NextHit(const RayLanes& rays, const double* tMin, const HitLanes& hits) const = 0;

  /// How often a ray can meet the surface: it is not asked for more.
  [[nodiscard]] virtual int MostHits() const = 0;

  /// The unit normal at a point of the surface.
  [[nodiscard]] virtual Vec3 Normal(const Vec3& position) const = 0;
};

struct Hit
{
  double t = kNoHit;
  Vec3 position{ 0.0 };
};

/// Surface::NextHit for one ray.
Hit NextHitOf(const Surface& surface, const Ray& ray, double tMin);
} // namespace pixelexact
