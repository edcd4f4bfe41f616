// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"

namespace pixelexact
{
/// Variation of the slopes over a piece, relative to the slopes: of a face's tangents and normal
/// or, with a field, of the map and of the field's gradient. Infinite if there is no Jacobian,
/// gradient or normal to compare with.
[[nodiscard]] double BendOf(const CurvedPiece& piece, bool hasField);
} // namespace pixelexact
