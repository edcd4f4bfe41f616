// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/CutGraph.h"
#include "Core/Integral/Integrand.h"

namespace pixelexact
{
/// Bounds of the integrals over whatever part of the cut-surface is in a box, by
/// IntegralCut::AreaIn.
Sums BoundIn(ElementFunctions& functions, const PieceBox& box);
/// The same where the surface is a graph over some of the (a, b), by ranges of the integrand.
Sums BoundOn(ElementFunctions& functions, const CutGraph& graph);
} // namespace pixelexact
