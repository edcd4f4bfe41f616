// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/FourierLayers.h"

#include <span>

namespace pixelexact::nektar
{
/// An element's coefficients.
std::span<const double> CoefficientsOf(const SolverExpansion& expansion, std::size_t e);

/// How near polynomials along z come to a field.
struct Accuracy
{
  int order = 0;
  double loss = 0.0;  ///< at most
  double range = 0.0; ///< at least
};

/// With the least order that is proven to lose no more than kHomogeneousLoss of the range, or the
/// highest.
Accuracy AccuracyOf(const HomogeneousField& field, const FourierLayers& layers);
} // namespace pixelexact::nektar
