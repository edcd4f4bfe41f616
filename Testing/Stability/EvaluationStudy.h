// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Stability/Report.h"

#include "Core/Basis/Space.h"

namespace pixelexact::testing
{
/// The choice of a field's coefficients.
enum class Coefficients
{
  Equal,      ///< every mode weighs the same: the worst that an order can do
  Decaying,   ///< as those of a smooth field
  Huge,       ///< 1e300
  Tiny,       ///< 1e-300, with products below the least normal number
  Mixed,      ///< 1e-300 to 1e300 in one element
  Cancelling, ///< the sum is smaller than its terms by up to 1e16
};

inline constexpr Coefficients kAllCoefficients[] = { Coefficients::Equal, Coefficients::Decaying,
  Coefficients::Huge, Coefficients::Tiny, Coefficients::Mixed, Coefficients::Cancelling };

const char* Name(Coefficients kind);

/// The five forms of spaces at one order.
std::vector<Space> EvaluationSpaces(int order);

/// Evaluates a field of one space at `points` points of the shape, some of them on faces, edges and
/// vertices or 1e-16 to 1 from what the shape collapses, and compares value and gradient by xi with
/// the reference. The condition is sum |c| |mode| over |sum c mode|. Allowed errors:
/// RoundingTape.h.
Row StudyEvaluation(
  const Space& space, Coefficients kind, int points, std::vector<ScatterPoint>* scatter = nullptr);
} // namespace pixelexact::testing
