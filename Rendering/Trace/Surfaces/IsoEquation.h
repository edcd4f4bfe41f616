// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/CurvedPiece.h"

namespace pixelexact
{
/// What makes an iso-surface of a component of a field, or of its magnitude (kMagnitude; of a
/// scalar field: the scalar). Throws Error for a component that is not there, for a value that is
/// not a finite number or, of a magnitude, not positive; Unsupported for mapped fields (H(curl),
/// H(div), density).
CurvedEquation IsoEquation(const Mesh& mesh, const Field& field, int component, double value);
} // namespace pixelexact
