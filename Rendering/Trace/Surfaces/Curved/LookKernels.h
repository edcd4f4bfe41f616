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
} // namespace pixelexact
