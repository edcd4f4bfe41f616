// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/PieceSolver.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// Whether so little is known of where the rays run, seen from far away, that no piece of the part
/// decides anything: rounding moves them by a part of the element.
[[nodiscard]] bool AreBlurred(const RayBundle& bundle, const Mesh& mesh, const CurvedPart& part);

/// All points where rays meet a piece that is too small to be halved further, by FindRoots: the
/// hits that it isolates are certain, and where it cannot tell there is an undecided one. For each
/// ray of the bundle it looks at no more than so many boxes, and takes those that it did from them.
void FindHits(const CurvedEquation& equation, const CurvedPart& part, const PartTree& tree,
  const RayBundle& bundle, PieceSolver& solver, const CurvedPiece& piece, const RaySet& rays,
  std::span<int> boxes, std::vector<CurvedHit>& hits);
} // namespace pixelexact
