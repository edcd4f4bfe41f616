// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/Krawczyk.h"

namespace pixelexact
{
using Sections = std::array<Section, 3>;

/// Where the hulls of a system over a box of these widths leave room for roots, direction by
/// direction; false where they leave none, a proof that there is none. Sections keep room around
/// what the coefficients' errors make of a root, and keep the box from becoming a sliver.
bool ClipSystem(const LocalSystem& system, const Parameters& width, Sections& sections);

/// Whether the coefficients' errors move roots by about the box's width, so that splitting would
/// not decide. Asked of the corner where the Jacobian is farthest from singular, for it may vanish
/// elsewhere.
bool IsLostInErrors(const LocalSystem& system);
} // namespace pixelexact
