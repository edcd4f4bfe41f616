// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Rays.h"
#include "Trace/Surfaces/HitSlots.h"

// Loops over the samples of a tile, in lanes: dispatched at run time to the instruction set.
namespace pixelexact
{
struct RayKernels
{
  /// Casts the rays through normalised device coordinates (u[i], v[i]), bit for bit as Camera::At.
  void (*cast)(const CameraRays& camera, const double* u, const double* v, int count,
    double* const origin[3], double* const direction[3]);
  /// Restricts the rays' intervals [near, far] to the box, enlarged by more than rounding.
  void (*clipToBox)(const Box3& box, const double* const origin[3],
    const double* const direction[3], int count, double* near, double* far);
  /// See Plane::Meet; `normal` is of unit length.
  void (*meetPlane)(
    const Vec3& origin, const Vec3& normal, const RayLanes& rays, const HitLanes& hits);
  /// Counts the `t` below kNoHit; the array is padded.
  int (*countHits)(const double* t, int count);
  bool (*areFinite)(const double* values, int count);
};

const RayKernels& GetRayKernels();
} // namespace pixelexact
