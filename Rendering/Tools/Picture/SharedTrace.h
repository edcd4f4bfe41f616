// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

#include <string>

// Pictures that several processes trace together, and options that one process alone takes.
namespace pixelexact
{
struct RenderOptions;

/// Throws UsageError where there are several: `what` is for one process.
void RefuseSeveralProcesses(const std::string& what);

/// The same for options of render that need more of the mesh than the surfaces intersect.
void CheckForSeveralProcesses(const RenderOptions& options);

struct View;

/// Trace(View) by several processes, which hold the same view and all call it: tile by tile in
/// turns. The first one's frame is then that which one process would have traced, bit for bit;
/// those of the others lack the tiles that were not theirs. The scene's counters of location are of
/// a process' own tiles.
Frame TraceTogether(const View& view, Buffer centres, const Progress& progress);
} // namespace pixelexact
