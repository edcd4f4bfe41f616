// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Rays.h"
#include "Trace/Surfaces/Curved/CurvedPiece.h"
#include "Trace/Surfaces/Curved/PieceSolver.h"
#include "Trace/Surfaces/HitSlots.h"

#include <span>

namespace pixelexact
{
/// The surface's data that hits are written with.
struct HitTerms
{
  std::span<const CurvedPart> parts;
  const Mesh& mesh;
  /// Hits store element and xi; otherwise pieces have the first two xi as parameters.
  bool tellsElements;
};

/// Writes a bundle's hits to slots, ray by ray in order of t. A hit that two parts share is written
/// once, and so are consecutive undecided hits of one part. If the rays need only their first hit,
/// only this one is written.
void WriteHits(const RayLanes& rays, int first, int count, const HitTerms& terms,
  std::span<const CurvedHit> found, HitSlots& hits);
} // namespace pixelexact
