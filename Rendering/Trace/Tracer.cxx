// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Tracer.h"

#include "Trace/BufferTable.h"
#include "Trace/FrameTiles.h"

#include <algorithm>
#include <chrono>
#include <cmath>
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
/// Buffers of centres that modules of later runs welcome, so that the frame keeps them.
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

template <class T>
void SpreadBlocks(std::vector<T>& buffer, std::size_t width, std::size_t step)
{
  const std::size_t height = buffer.empty() ? 0 : buffer.size() / width;
  for (std::size_t y = 0; y < height; ++y)
  {
    const auto row = buffer.begin() + static_cast<std::ptrdiff_t>(y * width);
    if (y % step != 0)
    {
      std::copy_n(row - static_cast<std::ptrdiff_t>(width), width, row);
      continue;
    }
    for (std::size_t x = 0; x < width; x += step)
    {
      const auto first = row + static_cast<std::ptrdiff_t>(x);
      std::fill_n(first, std::min(step, width - x), T(*first));
    }
  }
}

/// Counts the pixels by verdict.
void CountPixels(Frame& frame)
{
  const SampleBuffers& centres = frame.centres;
  FrameCounters& counters = frame.counters;
  const auto count = [&centres](PixelVerdict verdict)
  { return std::ranges::count(centres.verdict, static_cast<std::uint8_t>(verdict)); };
  counters.nothing = count(PixelVerdict::Nothing);
  counters.exact = count(PixelVerdict::Exact);
  counters.unknown = count(PixelVerdict::Unknown);
  counters.nonFinite = 0;
  for (std::size_t i = 0; i < centres.value.size(); ++i)
  {
    const bool exact = centres.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact);
    counters.nonFinite += exact && !std::isfinite(centres.value[i]) ? 1 : 0;
  }
}

/// Copies the samples of the lower left pixels of blocks of `step` x `step` pixels to all pixels of
/// their block.
void SpreadOverBlocks(Frame& frame, int step)
{
  const auto width = static_cast<std::size_t>(frame.width);
  const auto spread = [&](SampleBuffers& sheet)
  {
    ForEachBuffer([&](const auto& row)
      { SpreadBlocks(sheet.*row.member, width, static_cast<std::size_t>(step)); });
  };
  spread(frame.centres);
  std::ranges::for_each(frame.centres.behind, spread);
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
  // Modules visit the tiles of pixels even if they need only corners.
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
  // Modules of later runs visit all tiles again. With translucent layers, all runs do.
  const int visitsLater = static_cast<int>(pipeline.Runs().size()) - (translucent ? 0 : 1);
  if (!pipeline.modules.empty())
  {
    tiles += visitsLater * TilesOf(kCentres, frame.width, frame.height);
  }
  Reporter reporter(progress, tiles);
  if (extra.corners != Buffer::None)
  {
    // Corners come first, because modules read them.
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
    // The sheets are complete only after all tiles.
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
Frame TraceStrided(
  const Scene& scene, const Camera& camera, Buffer centres, int stride, const Progress& progress)
{
  const auto start = std::chrono::steady_clock::now();
  const SampleNeeds needs{ .centres = centres | Buffer::Verdict };
  RequireTraceable(scene, needs);
  Frame frame;
  frame.width = camera.Width();
  frame.height = camera.Height();
  frame.centres.Allocate(needs.centres, frame.width, frame.height);
  const int middle = stride / 2;
  const SampleLattice lattice{ middle + 0.5, 0, 0, stride };
  Reporter reporter(progress, TilesOf(lattice, frame.width, frame.height));
  Sheets sheets(frame.centres, needs.centres);
  frame.counters = TraceLattice(scene, camera, lattice, sheets, reporter, nullptr);
  SpreadOverBlocks(frame, stride);
  CountPixels(frame);
  frame.counters.seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return frame;
}
} // namespace pixelexact
