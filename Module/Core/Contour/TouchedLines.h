// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Contour/ContourSeeds.h"
#include "Core/Contour/CurveTracer.h"

#include <span>

namespace pixelexact
{
/// Lines in an element on which a field touches a value without crossing it: F - rho is a square
/// there, times something. On the surface the field's gradient vanishes along such a line, so that
/// it is followed as the zeros of the turn along . (grad F x grad s) (CurveEvaluator::FollowTurn).
///
/// The direction `along` is that at the first place, so that a line is followed only as long as it
/// turns by less than a right angle: closed ones are not found.
///
/// `open`: places next to which they are looked for. Of what is followed the pieces are returned on
/// which the value is reached at all points to within twice what the rounding of the coefficients
/// can move the field by. Nothing is proven of them: rounding alone may part or remove such a line.
std::vector<CurvePiece> FindTouchedLines(const ContourQuestion& question, int element, double value,
  std::span<const OpenPlace> open, const TraceLimits& limits);
} // namespace pixelexact
