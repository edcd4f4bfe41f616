// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Tree/EtaBox.h"

namespace pixelexact
{
/// Whether the map with these modes, in the element's units, has no thickness at points all over a
/// box of eta: det J is at most 1e-14 of the largest area between two of J's columns. Such boxes
/// are not worth halving; nothing is proven.
bool IsFlatOver(const Space& space, const double* modes, const EtaBox& box);
} // namespace pixelexact
