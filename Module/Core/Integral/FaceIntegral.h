// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Integral/Integrand.h"

namespace pixelexact
{
/// The integrals over a face of an element, number `face` of FacesOf(shape); the flux is out of the
/// element. With nu the outward gradient of the face's plane in xi (FacePlane),
///   n dS = cof J nu (collapse of the face) deta_a deta_b.
/// Parts are halved until all quantities' widths are within what is allowed, or `boxes` have been
/// looked at; `magnitudes` receives the sums of those over parts.
Sums IntegrateFace(ElementFunctions& functions, int face, const std::vector<double>& allowed,
  std::int64_t boxes, std::vector<double>& magnitudes);
} // namespace pixelexact
