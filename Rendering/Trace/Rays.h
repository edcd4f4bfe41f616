// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

#include <limits>

namespace pixelexact
{
/// The least t of a hit: a ray begins beyond its origin.
inline constexpr double kNearest = std::numeric_limits<double>::denorm_min();
/// The largest: no ray meets anything at infinity.
inline constexpr double kFarthest = std::numeric_limits<double>::max();

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
};
} // namespace pixelexact
