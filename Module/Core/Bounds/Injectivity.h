// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"

namespace pixelexact
{
/// How far the shape can be enlarged (as a Margin, see Shape.h) with A^-1 Phi still provably
/// injective there; 0 where no proof was found.
///
/// Criterion: on a convex domain a map whose Jacobian's symmetric part is positive definite is
/// injective, since (b - a) . (G(b) - G(a)) is the integral of (b - a) . DG (b - a) > 0. Bernstein
/// hulls enclose the entries of DG over the enlarged shape, and Gershgorin's circles prove
/// definiteness. Rotations do not weaken the criterion, as they would a bound on |DG - I|. Not
/// tried: pyramids, whose functions are rational in xi; hexahedra of order above
/// kMaxInjectivityOrder; prisms and tetrahedra of more than kMaxInjectivityModes modes, whose
/// matrices are dense.
///
/// `coefficients`: Phi, three components; `inverse`: A^-1, row-major.
double InjectiveMargin(const Space& space, const double* coefficients, const double* inverse);

inline constexpr int kMaxInjectivityOrder = 8;
inline constexpr int kMaxInjectivityModes = 100;
} // namespace pixelexact
