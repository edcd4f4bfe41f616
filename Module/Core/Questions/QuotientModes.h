// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Mesh.h"
#include "Core/Element/RangeIngredients.h"

#include <optional>

namespace pixelexact
{
/// A field that is mapped by J (see Mapping) in one element, as a quotient of polynomials in xi:
///
///   H(curl)  cof(J) F / det J,  H(div)  J F / det J,  densities  F / det J.
///
/// Both are interpolated in a space that holds them.
struct QuotientModes
{
  ScaledModes numerators; ///< of each component, in world values times det J of the element's units
  ScaledModes divisor;    ///< det J in the element's units; in the numerators' space
  /// Bounds the errors of the two polynomials: of each component, and of det J.
  double numeratorSlack = 0.0;
  double divisorSlack = 0.0;
  /// Bounds the errors of the two as ApplyMapping's kernels compute them.
  double numeratorError = 0.0;
  double divisorError = 0.0;

  /// The factor from slack to that of derivatives by xi, by Markov's inequality in convex bodies
  /// (D. Wilhelmsen, J. Approx. Theory 11, 1974), for shapes that are at least 1 wide.
  [[nodiscard]] double SlopeFactor() const;
};

/// `component`: of the field; -1: all. None on pyramids, where neither is a polynomial in xi, for
/// products of orders above 16, and for modes that are not finite. `rounding`: of the kernels' F,
/// as EdgeBounds takes it.
std::optional<QuotientModes> MakeQuotientModes(
  const Mesh& mesh, int element, const Field& field, int component, double rounding = 0.0);
} // namespace pixelexact
