// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
/// What a piece looks like to rays, in lanes: dispatched at run time to the instruction set, with
/// the same bits on all of them.
struct LookKernels
{
  /// Of rays and a flat piece: appends pairs where there may be a hit, and makes `open` those that
  /// have one root at most, which was not found in the piece; returns the rays to which the piece
  /// bends too much. The others miss it, proven. There must be room.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const RaySet& rays, PiecePairs& pairs, OpenRays& open);
};

const LookKernels& GetLookKernels();
} // namespace pixelexact
