// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Index/ElementIndex.h"

namespace pixelexact
{
/// Whether a segment is proven to meet no element of the mesh, by the elements' boxes and by the
/// boxes and frames of their trees, of which at most `effort` are visited. Intended for short
/// segments. True is a proof for every map within the uncertainty of the stored one and for the
/// segment moved by its slack. The result depends on the segment and the mesh alone.
[[nodiscard]] bool MissesMesh(const ElementIndex& index, const Segment& segment, int effort = 200);
} // namespace pixelexact
