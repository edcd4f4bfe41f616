// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TraceLattice.h"

#include "Core/Base/Error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <optional>

namespace pixelexact
{
namespace
{
/// Samples of a lattice along one side of an image.
int SamplesAlong(int first, int step, int size)
{
  return first < size ? (size - first + step - 1) / step : 0;
}

int TilesAlong(int samples)
{
  return (samples + kTileSize - 1) / kTileSize;
}
} // namespace

void RequireTraceable(const Scene& scene, const SampleNeeds& needs)
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
  if (scene.precision == Precision::Float && Has(needs.centres | needs.corners, Buffer::Enclosure))
  {
    throw Error("scene: values in single precision have no enclosures; ask for double precision.");
  }
}

Reporter::Reporter(const Progress& progress, int total)
  : TheProgress(progress)
  , Total(total)
  , Caller(std::this_thread::get_id())
{
}

void Reporter::TileDone()
{
  const int done = ++Done;
  // VTK's progress may be reported from the calling thread only.
  if (TheProgress && std::this_thread::get_id() == Caller &&
    !TheProgress(static_cast<double>(done) / Total))
  {
    Aborted = true;
  }
}

int TilesOf(const SampleLattice& lattice, int width, int height)
{
  return TilesAlong(SamplesAlong(lattice.x0, lattice.step, width)) *
    TilesAlong(SamplesAlong(lattice.y0, lattice.step, height));
}

FrameCounters TraceLattice(const Scene& scene, const Camera& camera, const SampleLattice& lattice,
  SampleBuffers& buffers, Reporter& reporter, StageTimes* stages)
{
  const int columns = SamplesAlong(lattice.x0, lattice.step, buffers.width);
  const int rows = SamplesAlong(lattice.y0, lattice.step, buffers.height);
  const int across = TilesAlong(columns);
  FrameCounters total;
  std::mutex mutex;
  tbb::parallel_for(0, across * TilesAlong(rows),
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
      if (stages)
      {
        clock.emplace();
      }
      TraceTile(scene, camera,
        { x, y, std::min(x + kTileSize, columns), std::min(y + kTileSize, rows) }, lattice, buffers,
        counters);
      reporter.TileDone();
      const std::scoped_lock lock(mutex);
      if (clock)
      {
        std::ranges::transform(clock->Times(), *stages, stages->begin(), std::plus<>());
      }
      AddCounters(counters, total);
    });
  total.nothing = static_cast<std::int64_t>(columns) * rows - total.exact - total.unknown;
  return total;
}

void AddCounters(const FrameCounters& counted, FrameCounters& total)
{
  total.rays += counted.rays;
  total.surfaceHits += counted.surfaceHits;
  total.nothing += counted.nothing;
  total.exact += counted.exact;
  total.unknown += counted.unknown;
  total.nonFinite += counted.nonFinite;
  total.floatCheck.Add(counted.floatCheck);
}
} // namespace pixelexact
