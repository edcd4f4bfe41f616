// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <span>

// Elements that are shown in parts, because polynomials of moderate orders come near rational
// functions only on small pieces.
namespace pixelexact::rational
{
/// Of a hexahedron, or a plane element, that is divided into equal parts along each direction.
struct ElementPart
{
  std::int32_t element = 0;
  std::array<int, 3> part{};        ///< along each direction, from 0
  std::array<int, 3> of{ 1, 1, 1 }; ///< powers of two
};

/// What functions on elements are on parts of them: the same polynomials, in the parts' xi; for
/// vectors and densities times what the mapping makes of that.
OwnedExpansion RestrictToParts(
  const OwnedExpansion& whole, Mapping mapping, std::span<const ElementPart> parts);
} // namespace pixelexact::rational
