// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CurveTracer.h"

#include <vector>

namespace pixelexact
{
/// Keeps the parts of pieces on which no clip of the question is positive. New ends lie on the
/// contour and on a clip's zeros, to rounding.
///
/// A part stays certain where each of its chords meets the clips' zeros at most once, as estimated:
/// the values at its ends leave room for the tolerance, or the clip changes monotonically along the
/// curve at both ends. An end that is not found makes the part lost.
std::vector<CurvePiece> ClipPieces(std::vector<CurvePiece> pieces, const ContourQuestion& question,
  CurveEvaluator& evaluator, double tolerance);
} // namespace pixelexact
