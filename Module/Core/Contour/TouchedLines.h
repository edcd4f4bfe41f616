// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourSeeds.h"
#include "Core/Contour/CurveTracer.h"

#include <span>

namespace pixelexact
{
/// Finds lines in an element on which a field touches a value without crossing it: F - rho has a
/// square as a factor there. On the surface the field's gradient vanishes along such a line, so
/// that it is followed as the zeros of the turn along . (grad F x grad s)
/// (CurveEvaluator::FollowTurn).
///
/// The direction `along` is that at the first place, so that a line is followed only as long as it
/// turns by less than a right angle; closed lines are not found.
///
/// `open`: places next to which lines are searched. Returns the pieces on which the field takes the
/// value at all points, to within twice the change of the field by the rounding of its
/// coefficients. They are not proven: rounding alone may split or remove such a line.
std::vector<CurvePiece> FindTouchedLines(const ContourQuestion& question, int element, double value,
  std::span<const OpenPlace> open, const TraceLimits& limits);
} // namespace pixelexact
