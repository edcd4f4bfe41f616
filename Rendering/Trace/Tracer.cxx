// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Tracer.h"

#include "Trace/FrameTiles.h"
#include "Trace/PipelineRuns.h"

#include <chrono>
#include <utility>

namespace pixelexact
{
namespace
{
void TraceCorners(const Scene& scene, const Camera& camera, Buffer wanted, Frame& frame,
  Reporter& reporter, StageTimes* stages)
{
  frame.corners.Allocate(wanted, frame.width + 1, frame.height + 1);
  Sheets sheets(frame.corners, wanted);
  AddSamples(TraceLattice(scene, camera, kCorners, sheets, reporter, stages), frame.counters);
}
/// What modules welcome that come when all tiles are there, so that the frame keeps it.
Buffer WelcomeLate(const Pipeline& pipeline, bool translucent)
{
  Buffer late = Buffer::None;
  const auto runs = pipeline.Runs();
  for (std::size_t i = translucent ? 0 : 1; i < runs.size(); ++i)
  {
    for (const FrameModule* module : runs[i])
    {
      late = late | module->Needs().welcome;
    }
  }
  return late;
}
} // namespace

Frame Trace(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  const SampleNeeds& extra, const Progress& progress, StageTimes* stages, Frame spare)
{
  const auto start = std::chrono::steady_clock::now();
  SampleNeeds needs = pipeline.Needs();
  needs.Add(extra);
  const bool translucent = HasTranslucent(scene);
  needs.centres = needs.centres | WelcomeLate(pipeline, translucent);
  RequireTraceable(scene, needs);
  Frame frame = std::move(spare);
  frame.counters = {};
  frame.color.clear();
  frame.width = camera.Width();
  frame.height = camera.Height();
  constexpr SampleLattice kCentres{ 0.5 };
  // A module may want nothing but corners, and still visits the tiles of pixels.
  const bool visits = needs.centres != Buffer::None || !pipeline.modules.empty();
  int tiles = 0;
  if (visits)
  {
    frame.centres.Allocate(needs.centres, frame.width, frame.height);
    tiles += TilesOf(kCentres, frame.width, frame.height);
  }
  else
  {
    frame.centres = {};
  }
  if (extra.corners != Buffer::None)
  {
    tiles += TilesOf(kCorners, frame.width + 1, frame.height + 1);
  }
  else
  {
    frame.corners = {};
  }
  // Modules of later runs visit the pixels' tiles again, of translucent scenes all of them do.
  const int visitsLater = static_cast<int>(pipeline.Runs().size()) - (translucent ? 0 : 1);
  if (!pipeline.modules.empty())
  {
    tiles += visitsLater * TilesOf(kCentres, frame.width, frame.height);
  }
  Reporter reporter(progress, tiles);
  if (extra.corners != Buffer::None)
  {
    // First, because modules read them.
    TraceCorners(scene, camera, extra.corners, frame, reporter, stages);
  }
  if (visits)
  {
    Sheets sheets(frame.centres, needs.centres);
    AfterTile after;
    if (!translucent)
    {
      BeginPipeline(pipeline, frame);
      after = [&, first = pipeline.Runs().front()](
                const TileArea& area, const SampleBuffers* own, FrameCounters& counters)
      { BeginPipelineOn(area, own, scene, camera, pipeline, first, frame, counters); };
    }
    const Buffer passing = translucent ? Buffer::None : Without(needs.welcome, needs.centres);
    AddCounters(TraceLattice(scene, camera, kCentres, sheets, reporter, stages,
                  { after, passing, extra.tiles }),
      frame.counters);
    if (after && !reporter.IsAborted())
    {
      AddSamples(FinishPipeline(scene, camera, pipeline, frame, reporter, stages), frame.counters);
    }
  }
  if (translucent)
  {
    // The sheets are known only when all tiles are.
    Reporter* const counts = pipeline.modules.empty() ? nullptr : &reporter;
    AddSamples(RunPipeline(&scene, &camera, pipeline, frame, counts, stages), frame.counters);
  }
  frame.counters.seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return frame;
}

bool KeepCorners(
  const Scene& scene, const Camera& camera, Buffer wanted, Frame& frame, const Progress& progress)
{
  if (wanted == Buffer::None || frame.corners.Holds(wanted))
  {
    return true;
  }
  Reporter reporter(progress, TilesOf(kCorners, frame.width + 1, frame.height + 1));
  TraceCorners(scene, camera, wanted, frame, reporter, nullptr);
  if (reporter.IsAborted())
  {
    frame.corners = {};
  }
  return !reporter.IsAborted();
}

void Repaint(const Scene& scene, const Camera& camera, const Pipeline& pipeline, Frame& frame)
{
  AddSamples(RunPipeline(&scene, &camera, pipeline, frame), frame.counters);
}

void Repaint(const Pipeline& pipeline, Frame& frame)
{
  (void)RunPipeline(nullptr, nullptr, pipeline, frame);
}
} // namespace pixelexact
