// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

namespace pixelexact
{
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
} // namespace pixelexact
