// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/Integrand.h"

namespace pixelexact
{
/// Integrates over a face of an element, number `face` of FacesOf(shape); the flux is out of the
/// element. With nu the outward gradient of the face's plane in xi (FacePlane), n dS = cof J nu
/// (collapse of the face) deta_a deta_b. Parts are subdivided until all quantities' widths are at
/// most `allowed`, or `boxes` have been visited. `magnitudes` receives the sums of the magnitudes
/// of the integrals over parts.
Sums IntegrateFace(ElementFunctions& functions, int face, const std::vector<double>& allowed,
  std::int64_t boxes, std::vector<double>& magnitudes);
} // namespace pixelexact
