// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace pixelexact
{
/// The least t of a hit: a ray begins beyond its origin.
inline constexpr double kNearest = std::numeric_limits<double>::denorm_min();
/// The largest: no ray meets anything at infinity.
inline constexpr double kFarthest = std::numeric_limits<double>::max();

/// The work of one ray: 50 ms of one core where nothing is kept, less where pieces are.
inline constexpr std::int64_t kRayWork = 12'000'000;
/// The least work of a ray in a picture, and what all rays of a picture may spend together as long
/// as each has this least.
inline constexpr std::int64_t kMinRayWork = 400'000;
inline constexpr std::int64_t kFrameWork = 40'000'000'000;

/// The share of each ray in the work of a picture. It depends on the picture's size and on the
/// number of its surfaces alone: not on the other rays, so that a pixel has the same answer in
/// every tile, pass and order.
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
  /// A ray's hits behind its first one are not needed: a surface may leave them out.
  bool nearestOnly = false;
  /// What a ray may spend alone, after all rays have been looked at together, in about nanoseconds
  /// (EdgeWork). A surface that needs more reports an Undecided hit.
  std::int64_t work = kRayWork;
};
} // namespace pixelexact
