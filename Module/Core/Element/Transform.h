// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"
#include "Core/Element/Mesh.h"
#include "Core/Math/Mat.h"

#include <vector>

namespace pixelexact
{
/// The Jacobian dPhi / dxi of the element's map at each point, in units of the element: column d is
/// the derivative by xi_d.
std::vector<Mat3> Jacobians(const Mesh& mesh, int element, const LanePoints& xi);

/// Turns gradients with respect to xi into gradients with respect to x, in place: each is
/// multiplied by the inverse transposed Jacobian of the element's map at its xi. `gradient` holds
/// 3 arrays per component, as KernelSet::gradient writes them. Where the Jacobian is singular the
/// result is infinite or NaN.
void ToWorldGradient(
  const Mesh& mesh, int element, const LanePoints& xi, int components, double* const* gradient);
} // namespace pixelexact
