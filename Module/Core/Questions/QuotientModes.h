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
  /// How far the two polynomials are off the exact ones, at most: each component, and det J.
  double numeratorSlack = 0.0;
  double divisorSlack = 0.0;
  /// How far off the two are as ApplyMapping's kernels make them.
  double numeratorError = 0.0;
  double divisorError = 0.0;

  /// What slack becomes in derivatives by xi: by Markov's inequality in convex bodies (D.
  /// Wilhelmsen, J. Approx. Theory 11, 1974), of shapes that are at least 1 wide.
  [[nodiscard]] double SlopeFactor() const;
};

/// `component`: of the field; -1: all. Nothing on pyramids, where neither is a polynomial in xi,
/// for products of orders above 16, and for modes that are not finite. `rounding`: of the kernels'
/// F, as EdgeBounds takes it.
std::optional<QuotientModes> MakeQuotientModes(
  const Mesh& mesh, int element, const Field& field, int component, double rounding = 0.0);
} // namespace pixelexact
