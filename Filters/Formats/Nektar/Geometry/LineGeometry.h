// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Nektar/Geometry/Geometry.h"

#include <string>

namespace pixelexact::nektar
{
/// Makes a geometry of segments (its edges, along x) one of quadrilaterals with the segments'
/// numbers, whose first direction is theirs. Vertices become the sides behind them, and so do those
/// of composites. `name`: of the file, for messages. Throws InvalidData without segments,
/// Unsupported for segments that do not lie along x.
void MakeStrip(const std::string& name, Geometry& geometry);
} // namespace pixelexact::nektar
