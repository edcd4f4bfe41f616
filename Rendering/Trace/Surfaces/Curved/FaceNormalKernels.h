// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pixelexact
{
/// Kernels in lanes, with the same bits on all instruction sets.
struct FaceNormalKernels
{
  /// Unit vectors along `sign` times the cross product of two tangents, with coordinates slope[2 c]
  /// and slope[2 c + 1]; zero where it vanishes. Arrays hold PaddedCount(count) doubles.
  void (*make)(double sign, const double* const slope[6], int count, double* const to[3]);
};

const FaceNormalKernels& GetFaceNormalKernels();
} // namespace pixelexact
