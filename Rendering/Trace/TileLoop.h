// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/FrameTiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <optional>

namespace pixelexact
{
inline int TilesAlong(int samples, int side = kTileSize)
{
  return (samples + side - 1) / side;
}

/// Whether a scene, which may be null, has to be traced by the calling thread.
inline bool NeedsCallingThread(const Scene* scene)
{
  return scene != nullptr &&
    std::ranges::any_of(
      scene->layers, [](const Layer& layer) { return layer.surface->NeedsCallingThread(); });
}

/// work(area, counters) for each tile of columns x rows samples, in parallel where the scene, which
/// may be null, allows it.
template <class Work>
FrameCounters ForEachTile(const Scene* scene, int columns, int rows, StageTimes* stages,
  const Work& work, int side = kTileSize)
{
  const int across = TilesAlong(columns, side);
  FrameCounters total;
  std::mutex mutex;
  const auto one = [&](int tile)
  {
    const int x = tile % across * side;
    const int y = tile / across * side;
    FrameCounters counters;
    std::optional<StageClock> clock;
    if (stages)
    {
      clock.emplace();
    }
    work(TileArea{ x, y, std::min(x + side, columns), std::min(y + side, rows) }, counters);
    const std::scoped_lock lock(mutex);
    if (clock)
    {
      std::ranges::transform(clock->Times(), *stages, stages->begin(), std::plus<>());
    }
    AddCounters(counters, total);
  };
  const int tiles = across * TilesAlong(rows, side);
  if (NeedsCallingThread(scene))
  {
    for (int tile = 0; tile < tiles; ++tile)
    {
      one(tile);
    }
  }
  else
  {
    tbb::parallel_for(0, tiles, one);
  }
  return total;
}
} // namespace pixelexact
