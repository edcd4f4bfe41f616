// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeWork.h"
#include "Trace/Surfaces/Curved/PieceSolver.h"

#include <vector>

namespace pixelexact
{
/// The rays' error, seen from far away, is so large a part of the element that no piece of the part
/// decides anything.
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

/// Adds an undecided hit of a ray with a piece. Its t is that of the piece's nearest point, so no
/// hit in the piece precedes it.
void AddUndecided(const RayBundle& bundle, const RayLanes& rays, PieceSolver& solver,
  const OpenPiece& open, std::vector<CurvedHit>& hits);

/// Finds all points where a ray meets a piece that is too small to be subdivided, by FindRoots.
/// Isolated roots are certain hits. If the search is undecided, or `work` is exhausted, adds an
/// undecided hit.
void FindHits(const MetPart& met, PieceSolver& solver, const OpenPiece& open, EdgeWork& work,
  std::vector<CurvedHit>& hits);
} // namespace pixelexact
