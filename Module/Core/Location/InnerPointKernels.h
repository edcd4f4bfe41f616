// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bounds/ElementBounds.h"

#include <cstdint>

namespace pixelexact
{
/// Returns those of at most 64 points y in the element's units, a bit each, for which the inverse
/// map's first guess is far enough from the faces that the element most likely holds them. This is
/// not a proof. None where the element has no guess, or a poor one.
std::uint64_t FindInnerPoints(const ElementBounds& bounds, const InverseProblem& problem,
  const LanePoints& y, std::uint64_t bits);
} // namespace pixelexact
