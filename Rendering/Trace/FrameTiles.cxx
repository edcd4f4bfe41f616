// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/FrameTiles.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"
#include "Trace/TileVisit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <optional>

namespace pixelexact
{
namespace
{
int TilesAlong(int samples, int side = kTileSize)
{
  return (samples + side - 1) / side;
}

/// The calling thread must trace the scene, which may be null.
bool NeedsCallingThread(const Scene* scene)
{
  return scene != nullptr &&
    std::ranges::any_of(
      scene->layers, [](const Layer& layer) { return layer.surface->NeedsCallingThread(); });
}

/// Calls work(area, counters) for each tile of columns x rows samples, in parallel if the scene
/// allows it. The scene may be null.
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

/// Count of a lattice's samples along one side of an image.
int SamplesAlong(int first, int step, int size)
{
  return first < size ? (size - first + step - 1) / step : 0;
}

/// Samples along a tile's side. Rays that are far apart share few elements, so a large tile would
/// evaluate many elements at few points each.
int SideOf(const SampleLattice& lattice)
{
  return lattice.step > 1 ? TileSamples::kRow : kTileSize;
}
} // namespace

void RequireTraceable(const Scene& scene, const SampleNeeds& needs)
{
  if (!scene.locator)
  {
    throw Error("scene: no data set to render; set one.");
  }
  if (scene.layers.empty() || scene.layers.size() > Scene::kMaxLayers)
  {
    throw Error(scene.layers.empty() ? "scene: no cut-surface to render; add at least one."
                                     : "scene: more than 255 layers; leave some out.");
  }
  const Buffer wanted = needs.centres | needs.corners | needs.edges;
  for (const Layer& layer : scene.layers)
  {
    if (!layer.surface)
    {
      throw Error("scene: a layer without surface; set one.");
    }
    if (!layer.field)
    {
      if (Has(wanted, Buffer::Value | Buffer::Enclosure))
      {
        throw Error("scene: a layer without field has no values; set one, or paint it in one "
                    "colour.");
      }
      continue;
    }
    const int components = layer.field->values.components;
    if (layer.component != kMagnitude && (layer.component < 0 || layer.component >= components))
    {
      throw Error("scene: field '" + layer.field->name + "' has no component " +
        std::to_string(layer.component) + "; it has " + std::to_string(components) +
        ", counted from 0.");
    }
    if (layer.precision == Precision::Float && Has(wanted, Buffer::Enclosure))
    {
      throw Error(
        "scene: values in single precision have no enclosures; ask for double precision.");
    }
  }
}

//--- Samples ---

int TilesOf(const SampleLattice& lattice, int width, int height)
{
  const int side = SideOf(lattice);
  return TilesAlong(SamplesAlong(lattice.x0, lattice.step, width), side) *
    TilesAlong(SamplesAlong(lattice.y0, lattice.step, height), side);
}

namespace
{
/// Copies a tile's samples to the frame, in the buffers that the frame has.
void KeepRows(const SampleBuffers& own, const TileArea& area, SampleBuffers& frame)
{
  ForEachBuffer(
    [&](const auto& row)
    {
      const auto& from = own.*row.member;
      auto& to = frame.*row.member;
      if (from.empty() || to.empty())
      {
        return;
      }
      for (int y = area.y0; y < area.y1; ++y)
      {
        std::copy_n(from.begin() + std::ptrdiff_t{ y - area.y0 } * area.Width(), area.Width(),
          to.begin() + std::ptrdiff_t{ y } * frame.width + area.x0);
      }
    });
}

/// Traces samples into arrays that last until the tile has been visited, and that are far smaller
/// than the frame's.
void TraceAlone(const Scene& scene, const Camera& camera, const TileArea& area,
  const SampleLattice& lattice, Sheets& sheets, const LatticeWork& work, FrameCounters& counters)
{
  const CheckedOut<SampleBuffers> own;
  const Buffer all = sheets.Buffers() | work.passing;
  (*own).Allocate(all, area.Width(), area.Height());
  {
    const CheckedOut<TileSamples> samples;
    {
      const StageScope scope(Stage::Rays);
      (*samples).BeginAlone(camera, area, lattice.offset);
    }
    Sheets alone(*own, all);
    TraceTile(scene, camera, *samples, alone, counters);
  }
  KeepRows(*own, area, sheets.At(0));
  work.after(area, &*own, counters);
}

void TraceInto(const Scene& scene, const Camera& camera, const TileArea& area,
  const SampleLattice& lattice, Sheets& sheets, const LatticeWork& work, FrameCounters& counters)
{
  {
    const CheckedOut<TileSamples> samples;
    {
      const StageScope scope(Stage::Rays);
      (*samples).Begin(camera, area, lattice, sheets.At(0).width);
    }
    TraceTile(scene, camera, *samples, sheets, counters);
  }
  if (work.after)
  {
    work.after(area, nullptr, counters);
  }
}
} // namespace

FrameCounters TraceLattice(const Scene& scene, const Camera& camera, const SampleLattice& lattice,
  Sheets& sheets, Reporter& reporter, StageTimes* stages, const LatticeWork& work)
{
  const int width = sheets.At(0).width;
  const int height = sheets.At(0).height;
  const int columns = lattice.packed ? width : SamplesAlong(lattice.x0, lattice.step, width);
  const int rows = lattice.packed ? height : SamplesAlong(lattice.y0, lattice.step, height);
  const int side = SideOf(lattice);
  const auto trace = work.passing != Buffer::None ? &TraceAlone : &TraceInto;
  FrameCounters total = ForEachTile(
    &scene, columns, rows, stages,
    [&](const TileArea& area, FrameCounters& counters)
    {
      const int tile = area.y0 / side * TilesAlong(columns, side) + area.x0 / side;
      std::uint8_t* const isDone =
        work.done != nullptr ? &(*work.done)[static_cast<std::size_t>(tile)] : nullptr;
      if (!work.turn.Has(tile) || (isDone != nullptr && *isDone != 0) || !reporter.HasTime())
      {
        return;
      }
      trace(scene, camera, area, lattice, sheets, work, counters);
      if (isDone != nullptr)
      {
        *isDone = 1;
      }
      reporter.TileDone();
    },
    side);
  total.nothing = static_cast<std::int64_t>(columns) * rows - total.exact - total.unknown;
  return total;
}

//--- Pipelines ---

void BeginPipeline(const Pipeline& pipeline, Frame& frame)
{
  for (FrameModule* module : pipeline.modules)
  {
    module->Begin(frame.width, frame.height);
  }
  if (pipeline.colors.empty())
  {
    return;
  }
  const std::size_t bytes = 4 * frame.centres.Size();
  const auto clear = [](std::vector<std::uint8_t>& color, std::size_t size)
  {
    // Avoids assign(), for which g++ 14 reports a false overflow.
    color.clear();
    color.resize(size);
  };
  clear(frame.centres.color, bytes);
  for (SampleBuffers& sheet : frame.centres.behind)
  {
    clear(sheet.color, bytes);
  }
  // Without an image of its own, the frame shows the nearest samples' colours.
  const bool hasImage = !frame.centres.behind.empty() || !pipeline.modules.empty();
  clear(frame.color, hasImage ? bytes : 0);
}

namespace
{
/// One run of modules over all tiles that are not in `done`, until `reporter` has no time.
FrameCounters RunModules(const Scene* scene, const Camera* camera, const Pipeline& pipeline,
  std::span<FrameModule* const> modules, bool makesImage, Frame& frame, StageTimes* stages,
  Reporter* reporter, TilesDone* done = nullptr)
{
  return ForEachTile(scene, frame.width, frame.height, stages,
    [&](const TileArea& area, FrameCounters& counters)
    {
      const int tile = area.y0 / kTileSize * TilesAlong(frame.width) + area.x0 / kTileSize;
      std::uint8_t* const isDone =
        done != nullptr ? &(*done)[static_cast<std::size_t>(tile)] : nullptr;
      if ((isDone != nullptr && *isDone != 0) || (reporter != nullptr && !reporter->HasTime()))
      {
        return;
      }
      TileVisit visit(scene, camera, pipeline, frame, area);
      if (makesImage)
      {
        visit.MakeImage();
      }
      visit.Run(modules);
      AddSamples(visit.Counters(), counters);
      if (isDone != nullptr)
      {
        *isDone = 1;
      }
      if (reporter != nullptr)
      {
        reporter->TileDone();
      }
    });
}

/// All runs from number `first` on.
FrameCounters RunFrom(std::size_t first, const Scene* scene, const Camera* camera,
  const Pipeline& pipeline, Frame& frame, StageTimes* stages, Reporter* reporter)
{
  FrameCounters total;
  const auto runs = pipeline.Runs();
  for (std::size_t i = first; i < runs.size(); ++i)
  {
    AddCounters(
      RunModules(scene, camera, pipeline, runs[i], i == 0, frame, stages, reporter), total);
  }
  return total;
}
} // namespace

void BeginPipelineOn(const TileArea& area, const SampleBuffers* own, const Scene& scene,
  const Camera& camera, const Pipeline& pipeline, std::span<FrameModule* const> modules,
  Frame& frame, FrameCounters& counters)
{
  TileVisit visit(&scene, &camera, pipeline, frame, area, own);
  visit.MakeImage();
  visit.Run(modules);
  AddSamples(visit.Counters(), counters);
}

FrameCounters FinishPipeline(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  Frame& frame, Reporter& reporter, StageTimes* stages)
{
  return RunFrom(1, &scene, &camera, pipeline, frame, stages, &reporter);
}

FrameCounters RunPipeline(const Scene* scene, const Camera* camera, const Pipeline& pipeline,
  Frame& frame, Reporter* reporter, StageTimes* stages)
{
  BeginPipeline(pipeline, frame);
  return RunFrom(0, scene, camera, pipeline, frame, stages, reporter);
}

FrameCounters RunPipelinePart(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  std::size_t run, Frame& frame, Reporter& reporter, TilesDone& done)
{
  return RunModules(
    &scene, &camera, pipeline, pipeline.Runs()[run], run == 0, frame, nullptr, &reporter, &done);
}

void AddSamples(const FrameCounters& counted, FrameCounters& total)
{
  total.rays += counted.rays;
  total.floatCheck.Add(counted.floatCheck);
}

void AddCounters(const FrameCounters& counted, FrameCounters& total)
{
  total.rays += counted.rays;
  total.surfaceHits += counted.surfaceHits;
  total.nothing += counted.nothing;
  total.exact += counted.exact;
  total.unknown += counted.unknown;
  total.nonFinite += counted.nonFinite;
  total.numericHits += counted.numericHits;
  total.undecidedHits += counted.undecidedHits;
  total.cutOff += counted.cutOff;
  total.floatCheck.Add(counted.floatCheck);
}
} // namespace pixelexact
