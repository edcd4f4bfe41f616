// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"

namespace pixelexact
{
/// In lanes, with the same bits on all instruction sets.
struct FaceNormalKernels
{
  /// Unit normals, of the directions that a normal in xi is taken to by derivatives of y (slope
  /// [3 c + d] of y_c by xi_d); zero where there is none. Arrays of PaddedCount(count).
  void (*make)(const Vec3& normal, const double* const slope[9], int count, double* const to[3]);
};

const FaceNormalKernels& GetFaceNormalKernels();
} // namespace pixelexact
