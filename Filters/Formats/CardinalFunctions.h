// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"

#include <functional>
#include <vector>

// Functions that are dual to functionals, such as values at nodes.
namespace pixelexact
{
/// Functions with scalar values on a reference element.
using SolidFunctions = std::function<void(const LongVec3& xi, long double* values)>;

/// From `count` functions to those that the functionals take to one and zero: function j of the
/// result is the sum over m of function m times the entry [m][j]. `functionals` has the value of
/// functional k for function m at [k][m].
std::vector<long double> DualMatrix(int count, const std::vector<long double>& functionals);

/// The sums that such a matrix (`terms` rows, `count` columns) stands for.
SolidFunctions Combined(
  SolidFunctions functions, int terms, const std::vector<long double>& matrix, int count);

/// The functions of `space` that are one at one of the nodes, and zero at the others.
SolidFunctions Cardinal(const Space& space, const std::vector<LongVec3>& nodes);
} // namespace pixelexact
