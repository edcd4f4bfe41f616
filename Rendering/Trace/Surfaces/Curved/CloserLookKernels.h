// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
/// Tests of rays against a piece from points near the rays' roots, in lanes, dispatched at run time
/// to the instruction set, with the same bits on all of them.
struct CloserLookKernels
{
  /// Tests the rays that a look left open. `values` are y (3), f and their derivatives (9 and 3) at
  /// the rays' xi, with `stride` numbers per row. Appends pairs where there may be a hit, and
  /// returns the rays that a further look does not help. Rays that it may help stay open, with
  /// smaller boxes of roots; the others are proven to miss the piece. The lists must have capacity.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const double* values, std::size_t stride, OpenRays& open, PiecePairs& pairs);
};

const CloserLookKernels& GetCloserLookKernels();
} // namespace pixelexact
