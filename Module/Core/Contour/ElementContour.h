// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourSeeds.h"
#include "Core/Contour/CurveTracer.h"

namespace pixelexact
{
/// Work budget of one element and value.
struct ContourEffort
{
  SeedEffort seeds{};
  int steps =
    300'000; ///< points of all pieces together; more than a line of the least tolerance has
};

/// The contour of one value in one element.
struct ElementContour
{
  std::vector<CurvePiece> pieces;
  std::vector<int> heldFaces; ///< as in SeedSearchResult
  bool complete = true;       ///< no piece is missing, proven
  bool constant = false;
  bool tooHigh = false;
  bool spent = false;         ///< the work budget was exhausted: it is not complete then
  std::ptrdiff_t touched = 0; ///< pieces that the field touches without crossing the value
};

/// Traces the contour of `value`; `tolerance` is in world units. The equations must be those of the
/// element, finite, and the hulls must allow the contour (MayMeetCut, MayHave).
ElementContour TraceElement(const ContourQuestion& question, const CurveEquations& equations,
  int element, double value, double tolerance, const ContourEffort& effort = {});
} // namespace pixelexact
