// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Math/Vec.h"

#include <array>
#include <vector>

// How far rounding can take an evaluation: every operation of the templates is recorded, and the
// derivative of the result by each operation's rounding error is found backwards. To first order
//
//   |error| <= sum over operations of |d result / d operation| (u |operation| + underflow)
//
// and no better bound exists, for each rounding may have the worse sign. A product and the sum it
// goes into are two roundings here, although one where the machine has fused operations.
namespace pixelexact::testing
{
/// Bound of the rounding error of the value of one component at xi.
double ValueRounding(const Space& space, const double* coefficients, const Vec3& xi);

/// The same where the gradient is evaluated as well: of the value and of its three derivatives.
std::array<double, 4> GradientRounding(
  const Space& space, const double* coefficients, const Vec3& xi);
} // namespace pixelexact::testing
