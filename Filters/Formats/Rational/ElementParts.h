// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/SolverModel.h"

#include <span>

// Parts of elements. Polynomials of moderate orders approximate rational functions well only on
// small parts.
namespace pixelexact::rational
{
/// A part of a hexahedron or plane element that is divided into equal parts along each direction.
struct ElementPart
{
  std::int32_t element = 0;
  std::array<int, 3> part{};        ///< along each direction, from 0
  std::array<int, 3> of{ 1, 1, 1 }; ///< powers of two
};

/// Restricts functions on elements to parts: the same polynomials in the parts' xi; vectors and
/// densities are scaled as the mapping requires.
OwnedExpansion RestrictToParts(
  const OwnedExpansion& whole, Mapping mapping, std::span<const ElementPart> parts);
} // namespace pixelexact::rational
