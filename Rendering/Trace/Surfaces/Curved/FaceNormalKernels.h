// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pixelexact
{
/// In lanes, with the same bits on all instruction sets.
struct FaceNormalKernels
{
  /// Unit vectors along sign times the product of two tangents, of which slope[2 c] and
  /// slope[2 c + 1] are the coordinates; zero where there is none. Arrays of PaddedCount(count).
  void (*make)(double sign, const double* const slope[6], int count, double* const to[3]);
};

const FaceNormalKernels& GetFaceNormalKernels();
} // namespace pixelexact
