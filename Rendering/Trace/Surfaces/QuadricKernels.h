// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/DoublePair.h"
#include "Trace/Rays.h"
#include "Trace/Surfaces/HitSlots.h"

namespace pixelexact
{
/// (x-c)^T Q (x-c) + 2 b.(x-c) + k.
struct QuadraticForm
{
  Vec3 centre{ 0.0 };
  DoublePair Q[6]; ///< xx, yy, zz, xy, yz, xz
  DoublePair b[3];
  DoublePair k;
};

/// |x-c|^2 - (v.(x-c))^2 + k: cylinders and cones.
struct AxisForm
{
  Vec3 centre{ 0.0 };
  DoublePair v[3];
  DoublePair k;
};

/// Intersection kernels in lanes, dispatched at run time to the instruction set. All of them give
/// the same bits.
struct QuadricKernels
{
  void (*meetSphere)(
    const Vec3& centre, const DoublePair& squaredRadius, const RayLanes& rays, HitSlots& hits);
  void (*meetRound)(const AxisForm& form, const RayLanes& rays, HitSlots& hits);
  void (*meetQuadric)(const QuadraticForm& form, const RayLanes& rays, HitSlots& hits);
  /// For a form with b = 0.
  void (*meetCentred)(const QuadraticForm& form, const RayLanes& rays, HitSlots& hits);
};

const QuadricKernels& GetQuadricKernels();
} // namespace pixelexact
