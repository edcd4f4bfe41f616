// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

namespace pixelexact
{
struct View;

/// Trace(View) by several processes, which hold the same view and all call it: tile by tile in
/// turns. The first one's frame is then that which one process would have traced, bit for bit;
/// those of the others lack the tiles that were not theirs. The scene's counters of location are of
/// a process' own tiles.
Frame TraceTogether(const View& view, Buffer centres, const Progress& progress);
} // namespace pixelexact
