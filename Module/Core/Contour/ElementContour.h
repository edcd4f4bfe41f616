// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/CurveTracer.h"

namespace pixelexact
{
/// The contour of one value in one element.
struct ElementContour
{
  std::vector<CurvePiece> pieces;
  std::vector<int> heldFaces; ///< as in SeedSearchResult
  bool complete = true;       ///< no piece is missing, proven
  bool constant = false;
  bool tooHigh = false;
};

/// The tolerance in world units. The equations are those of the element, finite, and the hulls
/// leave room for the contour (MayMeetCut, MayHave).
ElementContour TraceElement(const ContourQuestion& question, const CurveEquations& equations,
  int element, double value, double tolerance);
} // namespace pixelexact
