// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/DoublePair.h"
#include "Trace/Rays.h"
#include "Trace/Surfaces/HitSlots.h"

namespace pixelexact
{
/// f(y) = (|y|^2 - R^2 - r^2)^2 + (v.y)^2 - (2 R r)^2 with y = unit (x - centre); all members are
/// in these units.
struct TorusForm
{
  Vec3 centre;
  double unit;        ///< a power of two
  DoublePair axis[3]; ///< v, of length 2 R
  DoublePair sum;     ///< R^2 + r^2
  DoublePair product; ///< (2 R r)^2
  double slab;        ///< bound of |v.y| on the torus, a little more than 2 R r
  double reach;       ///< bound of |y| on the torus, a little more than R + r; at most 1
};

/// Intersection kernels in lanes, dispatched at run time to the instruction set. All of them give
/// the same bits.
struct TorusKernels
{
  void (*meet)(const TorusForm& form, const RayLanes& rays, HitSlots& hits);
};

const TorusKernels& GetTorusKernels();
} // namespace pixelexact
