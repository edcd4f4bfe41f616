// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/ProgressiveFrame.h"

#include "Trace/FrameTiles.h"
#include "Trace/StridedFrame.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pixelexact
{
namespace
{
/// The samples that are new when pixels `step` apart follow those `known` apart; 0: none yet.
std::vector<SampleLattice> LatticesOf(int step, int known)
{
  if (known == 0)
  {
    return { { 0.5, 0, 0, step } };
  }
  std::vector<SampleLattice> lattices;
  for (int y = 0; y < known; y += step)
  {
    for (int x = 0; x < known; x += step)
    {
      if (x > 0 || y > 0)
      {
        lattices.push_back({ 0.5, x, y, known });
      }
    }
  }
  return lattices;
}
} // namespace

ProgressiveFrame::ProgressiveFrame(
  Scene scene, const Camera& camera, Pipeline pipeline, Buffer extra, Buffer corners)
  : TheScene(std::move(scene))
  , TheCamera(camera)
  , ThePipeline(std::move(pipeline))
  , Needs(ThePipeline.Needs())
  , Corners(corners)
{
  Needs.centres = Needs.centres | extra;
  RequireTraceable(TheScene, Needs);
  TheFrame.width = camera.Width();
  TheFrame.height = camera.Height();
  TheFrame.centres.Allocate(Needs.centres, TheFrame.width, TheFrame.height);
}

bool ProgressiveFrame::Refine(const Progress& progress)
{
  return Known == 1 || Pass(Known == 0 ? kCoarsest : Known / 2, progress);
}

bool ProgressiveFrame::Complete(const Progress& progress)
{
  return Known == 1 || (Known == 0 ? AtOnce(progress) : Pass(1, progress));
}

bool ProgressiveFrame::AtOnce(const Progress& progress)
{
  bool aborted = false;
  const double before = TheFrame.counters.seconds;
  TheFrame =
    Trace(TheScene, TheCamera, ThePipeline, { .centres = Needs.centres, .corners = Corners },
      [&](double done)
      {
        aborted = progress && !progress(done);
        return !aborted;
      });
  TheFrame.counters.seconds += before;
  if (aborted)
  {
    // Those of some tiles.
    TheFrame.corners = {};
    TheFrame.color.clear();
    TheFrame.centres.color.clear();
    for (SampleBuffers& sheet : TheFrame.centres.behind)
    {
      sheet.color.clear();
    }
  }
  Known = aborted ? 0 : 1;
  return !aborted;
}

bool ProgressiveFrame::Pass(int step, const Progress& progress)
{
  const auto start = std::chrono::steady_clock::now();
  const std::vector<SampleLattice> lattices = LatticesOf(step, Known);
  int tiles = 0;
  for (const SampleLattice& lattice : lattices)
  {
    tiles += TilesOf(lattice, TheFrame.width, TheFrame.height);
  }
  Reporter reporter(progress, tiles);
  Sheets sheets(TheFrame.centres, Needs.centres);
  FrameCounters counted;
  for (const SampleLattice& lattice : lattices)
  {
    AddCounters(TraceLattice(TheScene, TheCamera, lattice, sheets, reporter, nullptr), counted);
  }
  bool aborted = reporter.IsAborted();
  if (step == 1 && !aborted)
  {
    const FrameCounters before = std::exchange(TheFrame.counters, {});
    aborted = !KeepCorners(TheScene, TheCamera, Corners, TheFrame, progress);
    AddSamples(std::exchange(TheFrame.counters, before), counted);
  }
  if (step == 1 && !aborted)
  {
    AddSamples(RunPipeline(&TheScene, &TheCamera, ThePipeline, TheFrame), counted);
  }
  TheFrame.counters.seconds +=
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double seconds = TheFrame.counters.seconds;
  TheFrame.counters = Finished;
  AddCounters(counted, TheFrame.counters);
  TheFrame.counters.seconds = seconds;
  if (aborted)
  {
    return false;
  }
  Finished = TheFrame.counters;
  Known = step;
  return true;
}

Frame ProgressiveFrame::Preview() const
{
  Frame frame = TheFrame;
  if (Known > 1)
  {
    SpreadOverBlocks(frame, Known);
  }
  Repaint({ .colors = ThePipeline.colors, .modules = {} }, frame);
  return frame;
}
} // namespace pixelexact
