// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

namespace pixelexact
{
/// Samples spread over the blocks of `step` x `step` pixels whose lower left one holds them.
void SpreadOverBlocks(Frame& frame, int step);

/// A frame with one sample for each block of `stride` x `stride` pixels, `stride` at least 1: that
/// of the block's middle pixel (of an even stride the one up and right of the middle), bit for bit
/// as Trace finds it, in all pixels of the block. Of a block that the right or upper edge cuts off
/// the middle may lie beyond the image. Counters: verdicts count pixels, rays samples. Throws Error
/// as Trace; aborted tiles are Nothing.
[[nodiscard]] Frame TraceStrided(const Scene& scene, const Camera& camera, Buffer centres,
  int stride, const Progress& progress = {});
} // namespace pixelexact
