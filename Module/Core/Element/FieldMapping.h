// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"

namespace pixelexact
{
/// Turns a field's reference values F(xi), and its gradients by xi, into world values and gradients
/// by x, in place (see Mapping). `value[c]` and `gradient[3 c + d]` are arrays over the points as
/// the kernels write them; `gradient` may be null. Where the Jacobian is singular the results that
/// need its inverse are infinite or NaN. Rounding: that of the kernels, times the condition of J.
void ApplyMapping(const Mesh& mesh, int element, Mapping mapping, const LanePoints& xi,
  int components, double* const* value, double* const* gradient);
} // namespace pixelexact
