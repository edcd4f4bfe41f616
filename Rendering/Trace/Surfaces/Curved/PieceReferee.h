// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/PieceSolver.h"

#include <vector>

namespace pixelexact
{
/// All points where rays meet a piece that is too small to be halved further, by FindRoots: the
/// hits that it isolates are certain, and where it cannot tell there is an undecided one.
void FindHits(Shape shape, const PartTree& tree, const RayBundle& bundle, PieceSolver& solver,
  const CurvedPiece& piece, const RaySet& rays, std::vector<CurvedHit>& hits);
} // namespace pixelexact
