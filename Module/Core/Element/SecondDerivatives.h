// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Math/Vec.h"

namespace pixelexact
{
/// d^2 y_c / d xi_j d xi_k as [c][j][k].
using Hessian = std::array<std::array<Vec3, 3>, 3>;

/// Second derivatives of three components at one point, in the units of the coefficients. Serial
/// and without lanes: for gradients of mapped fields, which are rare. At a pyramid's apex they do
/// not exist; those that depend on the way there are taken as zero.
Hessian SecondDerivatives(const Space& space, const double* coefficients, const Vec3& xi);
} // namespace pixelexact
