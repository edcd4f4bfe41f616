// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

namespace pixelexact
{
/// Samples along a tile's side: some hundred hits per element and query, and tiles enough to keep
/// all cores busy.
inline constexpr int kTileSize = 32;

/// A rectangle of a sample lattice, [x0, x1) x [y0, y1), of at most kTileSize each way.
struct TileArea
{
  int x0;
  int y0;
  int x1;
  int y1;
};

/// Casts the rays of a tile, locates and evaluates their hits, writes `buffers`. Samples lie at
/// image position (x + offset, y + offset): offset 0.5 for centres, 0 for corners. Only writes to
/// the tile's own entries; counters are added to `counters`.
void TraceTile(const Scene& scene, const Camera& camera, const TileArea& area, double offset,
  SampleBuffers& buffers, FrameCounters& counters);
} // namespace pixelexact
