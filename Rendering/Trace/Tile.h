// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

namespace pixelexact
{
/// Samples along a tile's side: some hundred hits per element and query, and tiles enough to keep
/// all cores busy.
inline constexpr int kTileSize = 32;

/// Samples of an image: (i, j) lies at image position (x0 + i step + offset, y0 + j step + offset)
/// and is the frame's sample (x0 + i step, y0 + j step).
struct SampleLattice
{
  double offset = 0.5; ///< 0.5: the pixels' centres, 0: their corners
  int x0 = 0;
  int y0 = 0;
  int step = 1;
};

/// A rectangle of a sample lattice, [x0, x1) x [y0, y1), of at most kTileSize each way.
struct TileArea
{
  int x0;
  int y0;
  int x1;
  int y1;
};

/// Casts the rays of a tile, locates and evaluates their hits, writes `buffers`. Only writes to the
/// tile's own entries; counters are added to `counters`. What a sample gets does not depend on the
/// others of its tile.
void TraceTile(const Scene& scene, const Camera& camera, const TileArea& area,
  const SampleLattice& lattice, SampleBuffers& buffers, FrameCounters& counters);
} // namespace pixelexact
