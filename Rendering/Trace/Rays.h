// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace pixelexact
{
/// The least t of a hit: rays exclude their origin.
inline constexpr double kNearest = std::numeric_limits<double>::denorm_min();
/// The largest t of a hit: rays meet nothing at infinity.
inline constexpr double kFarthest = std::numeric_limits<double>::max();

/// The work limit of one ray: 50 ms of one core without kept pieces, less with them.
inline constexpr std::int64_t kRayWork = 12'000'000;
/// The least work limit of a ray in a picture, and the work that the rays of a picture share unless
/// each gets only that least limit.
inline constexpr std::int64_t kMinRayWork = 400'000;
inline constexpr std::int64_t kFrameWork = 40'000'000'000;

/// The work limit of each ray of a picture. It depends only on the picture's size and the number of
/// its surfaces, not on other rays, so that a pixel has the same result in every tile, pass and
/// order.
[[nodiscard]] constexpr std::int64_t WorkOfRay(int width, int height, std::size_t surfaces)
{
  const std::int64_t rays = std::max<std::int64_t>(std::int64_t{ width } * height, 1) *
    static_cast<std::int64_t>(std::max<std::size_t>(surfaces, 1));
  return std::clamp(kFrameWork / rays, kMinRayWork, kRayWork);
}

/// Rays x(t) = origin + t direction with tNear <= t <= tFar, coordinate by coordinate; every array
/// holds PaddedCount(count) doubles. A ray with tNear > tFar meets nothing.
struct RayLanes
{
  const double* origin[3];
  const double* direction[3]; ///< of unit length up to rounding
  const double* tNear;        ///< at least kNearest
  const double* tFar;         ///< at most kFarthest
  int count;
  /// Hits after a ray's first one are not needed; a surface may omit them.
  bool nearestOnly = false;
  /// Work limit of a single ray, after all rays have been processed together, in about nanoseconds
  /// (EdgeWork). A surface that needs more reports an Undecided hit.
  std::int64_t work = kRayWork;
};
} // namespace pixelexact
