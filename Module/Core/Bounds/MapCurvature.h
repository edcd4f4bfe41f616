// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

namespace pixelexact
{
/// What is taken for a map of which nothing is known.
inline constexpr double kUnknownCurvature = 32.0;

/// About the largest || J(a)^-1 (J(b) - J(a)) || / || b - a || over the shape, max norms in xi:
/// what the square of a Newton step is multiplied by at most. From Jacobians at a lattice of
/// points, doubled: an estimate, not a bound. Of pyramids, whose Jacobians turn about the apex, in
/// units of the distance to it, the lesser of 1 and (1 - xi_3) / 2. Where a Jacobian cannot be
/// inverted, kUnknownCurvature.
double MapCurvature(const Space& space, const double* coefficients);
} // namespace pixelexact
