// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/ChangeOfBasis.h"

#include <functional>
#include <vector>

namespace pixelexact
{
/// The basis that a solver uses on one kind of element, and its way into the canonical one. Source
/// coefficients are in the solver's local order.
struct ElementBasis
{
  /// One part: scalar functions; each component of a field has its own `sources` coefficients.
  /// Three parts: vector functions (H(curl), H(div)); part d maps the same `sources` coefficients
  /// to component d in reference space (xi, not the solver's unit element).
  std::vector<ChangeOfBasis> parts;
  int sources = 0;

  [[nodiscard]] const Space& GetSpace() const { return parts.front().Target(); }
  [[nodiscard]] bool IsVector() const { return parts.size() == 3; }
};

// Functions that are dual to functionals, such as values at nodes.

/// Functions with scalar values on a reference element.
using SolidFunctions = std::function<void(const LongVec3& xi, long double* values)>;

/// The matrix from `count` functions to those that are dual to the functionals: function j of the
/// result is the sum over m of function m times the entry [m][j]. `functionals` contains the value
/// of functional k for function m at [k][m].
std::vector<long double> DualMatrix(int count, const std::vector<long double>& functionals);

/// The functions that such a matrix (`terms` rows, `count` columns) gives as sums of `functions`.
SolidFunctions Combined(
  SolidFunctions functions, int terms, const std::vector<long double>& matrix, int count);

/// The functions of `space` that are one at one of the nodes, and zero at the others.
SolidFunctions Cardinal(const Space& space, const std::vector<LongVec3>& nodes);
} // namespace pixelexact
