// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

namespace pixelexact
{
/// Rays x(t) = origin + t direction, coordinate by coordinate; every array holds PaddedCount(count)
/// doubles.
struct RayLanes
{
  const double* origin[3];
  const double* direction[3];
  int count;
};

/// Where rays meet a surface, padded as the rays are.
struct HitLanes
{
  double* t;
  double* position[3];
};
} // namespace pixelexact
