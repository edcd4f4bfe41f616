// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/ChangeOfBasis.h"

namespace pixelexact
{
/// A bound of how much noise of one unit in every source value can move the function anywhere in
/// the shape: of nodes, Lebesgue's constant, at most 1.6 times too large. Infinite where finding it
/// would take more than some tenths of a second (hexahedra and prisms above order 5, tetrahedra
/// above 7).
[[nodiscard]] double NoiseBound(const ChangeOfBasis& change);
} // namespace pixelexact
