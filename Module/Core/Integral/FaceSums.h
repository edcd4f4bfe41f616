// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/IntegralRounds.h"

#include <span>

namespace pixelexact
{
/// A face, and whether its flux counts out of its element, 1, or into it, -1.
struct SeenFace
{
  ElementFace face;
  double sense = 1.0;
};

/// Integrates over all faces, to a common tolerance. In parallel.
SurfaceIntegral OverFaces(const IntegralQuestion& question, std::span<const SeenFace> faces,
  const IntegralEffort& effort, const Deadline& deadline);
} // namespace pixelexact
