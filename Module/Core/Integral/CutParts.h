// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Faces/FaceTable.h"
#include "Core/Integral/FaceSums.h"
#include "Core/Location/Locator.h"

#include <cstdint>
#include <vector>

namespace pixelexact
{
/// Elements and faces that a cut meets.
struct CutParts
{
  std::vector<int> inside;    ///< elements that it meets in more than faces
  std::vector<SeenFace> held; ///< faces that lie in it, each once
  /// Faces on which it lies, unless it lies in the interior of the element behind them.
  std::vector<SeenFace> unsure;
  std::int64_t notFinite = 0; ///< elements that are left out, as in SurfaceIntegral
  std::int64_t tooHigh = 0;
  std::int64_t flat = 0;
};

/// The parts of the question's cut in a mesh; the locator and the faces are the mesh's. Parallel;
/// the result is independent of the number of threads.
CutParts FindCutParts(
  const IntegralQuestion& question, const Locator& locator, const FaceTable& faces);

/// Throws Unsupported where sizes would over- or underflow: functions of the place of degree n are
/// of the size of lengths^n, and the integrals of these times lengths^3.
void CheckSizes(const IntegralQuestion& question);

/// Whether the field is a function without models on an element of the mesh: its errors are
/// estimates.
bool IsNumeric(const IntegralQuestion& question);
} // namespace pixelexact
