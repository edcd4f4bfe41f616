// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Tree/FrameKernels.h"
#include "Core/Tree/NodeFrame.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
/// Differences of neighbours among the coefficients of a frame's deviation D: [row][direction].
using DeviationSteps = std::array<std::array<FrameSteps, 3>, 3>;

inline double LargestStep(const FrameSteps& steps)
{
  return std::max(-steps.least, steps.most);
}

/// Whether the frame proves that Phi, of this degree, is injective over a hexahedron's box and its
/// reach (ReachOf): the derivatives of D = A^-1 Phi - xi are small, or, with `products`, they
/// hardly vary. False proves nothing.
bool IsInjective(const std::array<int, 3>& degree, const DeviationSteps& steps,
  const NodeFrame& frame, bool products);
} // namespace pixelexact
