// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Element/Kernels.h"

#include <cstdint>

namespace pixelexact
{
/// Returns those of `count` roots, a bit each, at which Phi is y up to `mostMiss` times the
/// uncertainty. `phi`: its three coordinates there and their nine derivatives. Stores the faces'
/// tolerances: |J^-1| times the uncertainty; zero where J is singular.
std::uint64_t CheckImages(const InverseProblem& problem, double mostMiss, int count,
  const double* const phi[12], const double* const y[3], double* const tolerance[3]);
} // namespace pixelexact
