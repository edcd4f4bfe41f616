// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Homogeneous/FourierLayers.h"

#include <span>

namespace pixelexact::nektar
{
/// An element's coefficients.
std::span<const double> CoefficientsOf(const SolverExpansion& expansion, std::size_t e);

/// How near polynomials come to a field.
struct Accuracy
{
  int orderY = 0;
  int orderZ = 0;
  double loss = 0.0;  ///< at most
  double range = 0.0; ///< at least
};

/// With orders that are proven to lose no more than kHomogeneousLoss of the range, each the least
/// that will do, or the highest. `y` is null where the mesh is two-dimensional.
Accuracy AccuracyOf(const HomogeneousField& field, const FourierLayers* y, const FourierLayers& z);
} // namespace pixelexact::nektar
