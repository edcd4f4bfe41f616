// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Scene.h"
#include "Trace/Sheets.h"
#include "Trace/TileSamples.h"

namespace pixelexact
{

/// Finds all hits of the samples' rays, once; walks each ray from hit to hit, in the order of t, at
/// equal t of the layers; locates and evaluates. A hit that is outside of the mesh lets its ray go
/// on; so does, to the next sheet, one that is seen on a translucent layer. Writes to the samples'
/// own places alone; counters are added to `counters`. What a sample gets does not depend on the
/// others.
void WalkTile(const Scene& scene, const Camera& camera, TileSamples& samples, Sheets& sheets,
  FrameCounters& counters);
} // namespace pixelexact
