// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
/// What a piece looks like to rays from a point near their roots, in lanes: dispatched at run time
/// to the instruction set, with the same bits on all of them.
struct CloserLookKernels
{
  /// Of rays that a look left open: `values` are y (3), f, their derivatives (9 and 3) at the rays'
  /// xi, each `stride` after the other. Appends pairs where there may be a hit; returns the rays
  /// that another look does not help. Those that it may help stay open, closer to their roots; the
  /// others miss the piece, proven. There must be room.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const double* values, std::size_t stride, OpenRays& open, PiecePairs& pairs);
};

const CloserLookKernels& GetCloserLookKernels();
} // namespace pixelexact
