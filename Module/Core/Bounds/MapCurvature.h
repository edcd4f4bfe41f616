// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

namespace pixelexact
{
/// Default curvature.
inline constexpr double kUnknownCurvature = 32.0;

/// Estimates the largest
///
/// J(a)^-1 (J(b) - J(a))
///
/// /
///
/// b - a
///
/// over the shape, max norms in xi: after a Newton step the error is at most this number times the
/// square of the error before it. Takes Jacobians at a lattice of points and doubles the result: an
/// estimate, not a bound. Jacobians of pyramids vary with the direction to the apex, so lengths are
/// in units of the lesser of 1 and (1 - xi_3) / 2. Returns kUnknownCurvature where a Jacobian
/// cannot be inverted.
double MapCurvature(const Space& space, const double* coefficients);

/// Computes InverseProblem::bend, a bound of the change of a map's Jacobian. `coefficients`: three
/// components, in the element's units.
double MapBend(const Space& space, const double* coefficients);
} // namespace pixelexact
