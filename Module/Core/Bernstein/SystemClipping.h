// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bernstein/Krawczyk.h"

namespace pixelexact
{
using Sections = std::array<Section, 3>;

/// Computes the sections of a box of these widths that may hold roots of a system by the hulls,
/// direction by direction. Returns false where there are none, a proof that there is no root.
/// Sections keep a margin for the effect of the coefficients' errors on a root, and keep the box
/// from becoming a sliver.
bool ClipSystem(const LocalSystem& system, const Parameters& width, Sections& sections);

/// Whether the coefficients' errors move roots by about the box's width, so that splitting would
/// not decide. Asked of the corner where the Jacobian is farthest from singular, for it may vanish
/// elsewhere.
bool IsLostInErrors(const LocalSystem& system);
} // namespace pixelexact
