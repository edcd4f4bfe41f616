// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/CollectionName.h"

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/LineFunctions.h"

#include <functional>
#include <vector>

// What MFEM's bases are made of: points on the line, and functions that are dual to functionals.
namespace pixelexact::mfem
{
/// n points of a line basis in [-1,1], ascending; integrated functions have Gauss's.
std::vector<long double> LinePoints(LineBasis basis, int n);
/// The functions of a line basis, `count` of them, of order count - 1.
LineFunctions LineOf(LineBasis basis, int count);
/// `count` functions whose integrals over the intervals between count + 1 closed points, in [0,1],
/// are one or zero; from the derivatives of the points' Lagrange polynomials, as MFEM makes them.
LineFunctions IntegratedOf(LineBasis closed, int count);
/// The same functions of -z.
LineFunctions Mirrored(LineFunctions line);
/// The same functions, times a factor.
LineFunctions Times(long double factor, LineFunctions line);

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
} // namespace pixelexact::mfem
