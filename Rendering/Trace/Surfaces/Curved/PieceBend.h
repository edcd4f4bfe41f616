// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"

namespace pixelexact
{
/// How much the slopes vary over a piece, relative to themselves: of a face's tangents and normal,
/// or, with a field, of the map and of the field's gradient. Infinite where there is nothing to
/// compare with: no Jacobian, no gradient, no normal.
[[nodiscard]] double BendOf(const CurvedPiece& piece, bool hasField);
} // namespace pixelexact
