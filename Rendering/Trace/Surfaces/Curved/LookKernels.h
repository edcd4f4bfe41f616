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
  /// Of rays and a flat piece: makes `near` those that may meet it, and returns those of which
  /// nothing is known. The others miss it, proven.
  RaySet (*look)(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    const RaySet& rays, OpenRays& near);
};

const LookKernels& GetLookKernels();
} // namespace pixelexact
