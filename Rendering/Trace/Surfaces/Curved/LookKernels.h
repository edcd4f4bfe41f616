// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
/// Tests of rays against a piece, in lanes, dispatched at run time to the instruction set, with the
/// same bits on all of them.
struct LookKernels
{
  /// Tests rays against a flat piece: sets `near` to the rays that may meet it, and returns those
  /// about which nothing is proven. The other rays are proven to miss it.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const RaySet& rays, OpenRays& near);
};

const LookKernels& GetLookKernels();

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

/// Tests of rays that may meet a piece more than once, by f along the ray, in lanes, dispatched at
/// run time to the instruction set, with the same bits on all of them.
struct AlongRayKernels
{
  /// Tests the rays for which a look found too much bending. Appends pairs where there may be a
  /// hit. Appends a ray to `open`, once per place, if it has at most one root there and the root
  /// was not expected in the piece. Returns the rays for which the piece bends too much; the others
  /// are proven to miss it. The lists must have capacity for two entries per ray.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    OpenRays& bent, OpenRays& open, PiecePairs& pairs);
};

const AlongRayKernels& GetAlongRayKernels();

/// The kernels of LookKernels and PieceKernels for pieces of faces. They work in the two xi of the
/// face's chart, so that a ray gives two equations for two unknowns. In lanes, with the same bits
/// on all instruction sets.
struct FacePieceKernels
{
  /// As LookKernels::look, but appends pairs.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const RaySet& rays, PiecePairs& pairs);
  /// As PieceKernels::step, with other `values`: y (3), an unused row, and the derivatives of y by
  /// the chart's u and v (6).
  void (*step)(const RayBundle& bundle, const ElementFrame& frame, const double* values,
    std::size_t stride, PiecePairs& pairs, double* const position[3], double* result);
};

const FacePieceKernels& GetFacePieceKernels();
} // namespace pixelexact
