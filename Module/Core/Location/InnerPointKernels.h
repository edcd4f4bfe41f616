// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Bounds/ElementBounds.h"

#include <cstdint>

namespace pixelexact
{
/// Of at most 64 points y in the element's units, a bit each, those of which the inverse map's
/// first guess is far enough from the faces that the element most likely holds them. Nothing is
/// proven. None where the element has no guess, or a poor one.
std::uint64_t FindInnerPoints(const ElementBounds& bounds, const InverseProblem& problem,
  const LanePoints& y, std::uint64_t bits);
} // namespace pixelexact
