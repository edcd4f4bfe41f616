// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Rays.h"
#include "Trace/Surfaces/HitSlots.h"

namespace pixelexact
{
/// A plane through a point; the unit normal points out of the body.
struct ConvexFace
{
  Vec3 point;
  Vec3 normal;
};

/// Intersection kernels in lanes, dispatched at run time to the instruction set. All of them give
/// the same bits.
struct ConvexKernels
{
  void (*meet)(const ConvexFace* faces, int count, const RayLanes& rays, HitSlots& hits);
};

const ConvexKernels& GetConvexKernels();
} // namespace pixelexact
