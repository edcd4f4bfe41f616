// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Homogeneous/FourierLayers.h"

#include <span>

// From one layer of elements to many, with Fourier's functions as polynomials across them.
namespace pixelexact::nektar
{
/// Where the layers are put, one above the other.
enum class Along : std::uint8_t
{
  Y,
  Z
};

/// Copies the elements into the layers, once from each of `begin` on. A map's modes along the
/// direction go: what was there is a slab. Throws Unsupported for more elements, or larger numbers,
/// than there may be.
void LiftMesh(
  const FourierLayers& layers, Along direction, const std::vector<double>& begin, SolverMesh& mesh);

/// The field on them: `planes` has all functions of one beginning after the other.
SolverExpansion LiftField(
  std::span<const SolverExpansion> planes, const FourierLayers& layers, Along direction, int order);
} // namespace pixelexact::nektar
