// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/PipelineRuns.h"

#include "Trace/TileLoop.h"
#include "Trace/TileVisit.h"

#include <vector>

namespace pixelexact
{
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
    // Not assign(), of which g++ 14 believes that it may run over.
    color.clear();
    color.resize(size);
  };
  clear(frame.centres.color, bytes);
  for (SampleBuffers& sheet : frame.centres.behind)
  {
    clear(sheet.color, bytes);
  }
  // Else the nearest samples' colours are the image.
  const bool hasImage = !frame.centres.behind.empty() || !pipeline.modules.empty();
  clear(frame.color, hasImage ? bytes : 0);
}

namespace
{
/// One run of modules over all tiles, of `done` those that are not; until `reporter` has no time.
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

/// The runs from one on.
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
} // namespace pixelexact
