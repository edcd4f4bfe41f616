// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"
#include "Core/Math/Vec.h"

#include <array>
#include <span>

namespace pixelexact
{
/// Turns a field's reference values F(xi), and its gradients by xi, into world values and gradients
/// by x, in place (see Mapping). `value[c]` and `gradient[3 c + d]` are arrays over the points as
/// the kernels write them; `gradient` may be null. Where the Jacobian is singular the results that
/// need its inverse are infinite or NaN. Rounding: that of the kernels, times the condition of J.
void ApplyMapping(const Mesh& mesh, int element, Mapping mapping, const LanePoints& xi,
  int components, double* const* value, double* const* gradient);

/// d^2 y_c / d xi_j d xi_k as [c][j][k].
using Hessian = std::array<std::array<Vec3, 3>, 3>;

/// Second derivatives by xi of as many components as `out` holds, at one point, in the units of the
/// coefficients. Serial and without lanes: for gradients of mapped fields and expressions with
/// second derivatives, which are rare. At a pyramid's apex they do not exist; those that depend on
/// the way there are taken as zero.
void SecondDerivatives(const Space& space, const double* coefficients, const Vec3& xi,
  std::span<Hessian::value_type> out);
} // namespace pixelexact
