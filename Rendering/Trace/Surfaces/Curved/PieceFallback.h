// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeWork.h"
#include "Trace/Surfaces/Curved/PieceSolver.h"

#include <vector>

namespace pixelexact
{
/// Whether so little is known of where the rays run, seen from far away, that no piece of the part
/// decides anything: rounding moves them by a part of the element.
[[nodiscard]] bool AreBlurred(const RayBundle& bundle, const Mesh& mesh, const CurvedPart& part);

/// A part, and the rays that come near it.
struct MetPart
{
  const CurvedEquation& equation;
  const CurvedPart& part;
  const PartTree& tree;
  const RayBundle& bundle;
  const RayLanes& rays;
};

/// An undecided hit of a ray with a piece. Its t is that of the piece's nearest point: no hit in
/// the piece lies before it.
void AddUndecided(const RayBundle& bundle, const RayLanes& rays, PieceSolver& solver,
  const OpenPiece& open, std::vector<CurvedHit>& hits);

/// All points where a ray meets a piece that is too small to be halved further, by FindRoots: the
/// hits that it isolates are certain, and where it cannot tell, or `work` is exhausted, there is an
/// undecided one.
void FindHits(const MetPart& met, PieceSolver& solver, const OpenPiece& open, EdgeWork& work,
  std::vector<CurvedHit>& hits);
} // namespace pixelexact
