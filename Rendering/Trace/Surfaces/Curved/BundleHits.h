// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Rays.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/PieceSolver.h"
#include "Trace/Surfaces/HitSlots.h"

#include <span>

namespace pixelexact
{
/// What hits of a bundle are written with.
struct HitTerms
{
  std::span<const CurvedPart> parts;
  const Mesh& mesh;
  bool tellsElements; ///< else pieces have the first two xi as parameters
};

/// Takes a bundle's hits to slots, ray by ray in order: what two parts share once, what is
/// undecided in a part once, and where rays want no more, the first alone.
void WriteHits(const RayLanes& rays, int first, int count, const HitTerms& terms,
  std::span<const CurvedHit> found, HitSlots& hits);
} // namespace pixelexact
