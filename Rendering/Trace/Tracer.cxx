// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Tracer.h"

#include "Core/Base/Error.h"
#include "Trace/Tile.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace pixelexact
{
namespace
{
void Require(const Scene& scene)
{
  if (!scene.locator || !scene.field)
  {
    throw Error("scene: no data set or no field to render; set both.");
  }
  if (scene.surfaces.empty())
  {
    throw Error("scene: no cut-surface to render; add at least one.");
  }
  if (scene.component != Scene::kMagnitude &&
    (scene.component < 0 || scene.component >= scene.field->values.components))
  {
    throw Error("scene: field '" + scene.field->name + "' has no component " +
      std::to_string(scene.component) + "; it has " +
      std::to_string(scene.field->values.components) + ", counted from 0.");
  }
}

/// Progress and abort, shared by the tiles of a frame.
class Reporter
{
public:
  Reporter(const Progress& progress, int total)
    : TheProgress(progress)
    , Total(total)
    , Caller(std::this_thread::get_id())
  {
  }

  [[nodiscard]] bool IsAborted() const { return Aborted; }

  void TileDone()
  {
    const int done = ++Done;
    // VTK's progress may be reported from the calling thread only.
    if (TheProgress && std::this_thread::get_id() == Caller &&
      !TheProgress(static_cast<double>(done) / Total))
    {
      Aborted = true;
    }
  }

private:
  const Progress& TheProgress;
  int Total;
  std::thread::id Caller;
  std::atomic<int> Done{ 0 };
  std::atomic<bool> Aborted{ false };
};

struct Lattice
{
  SampleBuffers* buffers;
  double offset;
  StageTimes* stages;
};

int TilesAlong(int samples)
{
  return (samples + kTileSize - 1) / kTileSize;
}

FrameCounters TraceLattice(
  const Scene& scene, const Camera& camera, const Lattice& lattice, Reporter& reporter)
{
  const int width = lattice.buffers->width;
  const int height = lattice.buffers->height;
  const int across = TilesAlong(width);
  FrameCounters total;
  std::mutex mutex;
  tbb::parallel_for(0, across * TilesAlong(height),
    [&](int tile)
    {
      if (reporter.IsAborted())
      {
        return;
      }
      const int x = tile % across * kTileSize;
      const int y = tile / across * kTileSize;
      FrameCounters counters;
      std::optional<StageClock> clock;
      if (lattice.stages)
      {
        clock.emplace();
      }
      TraceTile(scene, camera,
        { x, y, std::min(x + kTileSize, width), std::min(y + kTileSize, height) }, lattice.offset,
        *lattice.buffers, counters);
      reporter.TileDone();
      const std::scoped_lock lock(mutex);
      if (clock)
      {
        std::ranges::transform(
          clock->Times(), *lattice.stages, lattice.stages->begin(), std::plus<>());
      }
      total.rays += counters.rays;
      total.surfaceHits += counters.surfaceHits;
      total.exact += counters.exact;
      total.unknown += counters.unknown;
      total.nonFinite += counters.nonFinite;
    });
  total.nothing = static_cast<std::int64_t>(lattice.buffers->Size()) - total.exact - total.unknown;
  return total;
}
} // namespace

Frame Trace(const Scene& scene, const Camera& camera,
  const std::vector<const FrameModule*>& modules, const SampleNeeds& extra,
  const Progress& progress, StageTimes* stages)
{
  Require(scene);
  const auto start = std::chrono::steady_clock::now();
  SampleNeeds needs = extra;
  for (const auto* module : modules)
  {
    const SampleNeeds wanted = module->Needs();
    needs.centres = needs.centres | wanted.centres;
    needs.corners = needs.corners | wanted.corners;
  }
  Frame frame;
  frame.width = camera.Width();
  frame.height = camera.Height();
  int tiles = 0;
  if (needs.centres != Buffer::None)
  {
    frame.centres.Allocate(needs.centres, frame.width, frame.height);
    tiles += TilesAlong(frame.width) * TilesAlong(frame.height);
  }
  if (needs.corners != Buffer::None)
  {
    frame.corners.Allocate(needs.corners, frame.width + 1, frame.height + 1);
    tiles += TilesAlong(frame.width + 1) * TilesAlong(frame.height + 1);
  }
  Reporter reporter(progress, tiles);
  if (needs.centres != Buffer::None)
  {
    frame.counters = TraceLattice(scene, camera, { &frame.centres, 0.5, stages }, reporter);
  }
  if (needs.corners != Buffer::None)
  {
    frame.counters.rays +=
      TraceLattice(scene, camera, { &frame.corners, 0.0, stages }, reporter).rays;
  }
  const auto traced = std::chrono::steady_clock::now();
  for (const auto* module : modules)
  {
    module->Process(frame);
  }
  if (stages)
  {
    (*stages)[static_cast<std::size_t>(Stage::Modules)] +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - traced).count();
  }
  frame.counters.seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return frame;
}
} // namespace pixelexact
