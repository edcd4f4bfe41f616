// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
/// What a piece looks like along rays that may meet it more than once, in lanes: dispatched at run
/// time to the instruction set, with the same bits on all of them.
struct AlongRayKernels
{
  /// Of rays that a look left bent: appends pairs where there may be a hit, and to `open` rays,
  /// once for each place, that have in this place one root at most, which was not expected in the
  /// piece. Returns the rays to which the piece bends too much; the others miss it, proven. There
  /// must be room for two of each ray.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    OpenRays& bent, OpenRays& open, PiecePairs& pairs);
};

const AlongRayKernels& GetAlongRayKernels();
} // namespace pixelexact
