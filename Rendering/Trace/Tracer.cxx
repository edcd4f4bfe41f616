// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Tracer.h"

#include "Trace/TraceLattice.h"

#include <chrono>

namespace pixelexact
{
Frame Trace(const Scene& scene, const Camera& camera,
  const std::vector<const FrameModule*>& modules, const SampleNeeds& extra,
  const Progress& progress, StageTimes* stages)
{
  const auto start = std::chrono::steady_clock::now();
  SampleNeeds needs = extra;
  for (const auto* module : modules)
  {
    const SampleNeeds wanted = module->Needs();
    needs.centres = needs.centres | wanted.centres;
    needs.corners = needs.corners | wanted.corners;
  }
  RequireTraceable(scene, needs);
  Frame frame;
  frame.width = camera.Width();
  frame.height = camera.Height();
  constexpr SampleLattice kCentres{ 0.5 };
  constexpr SampleLattice kCorners{ 0.0 };
  int tiles = 0;
  if (needs.centres != Buffer::None)
  {
    frame.centres.Allocate(needs.centres, frame.width, frame.height);
    tiles += TilesOf(kCentres, frame.width, frame.height);
  }
  if (needs.corners != Buffer::None)
  {
    frame.corners.Allocate(needs.corners, frame.width + 1, frame.height + 1);
    tiles += TilesOf(kCorners, frame.width + 1, frame.height + 1);
  }
  Reporter reporter(progress, tiles);
  if (needs.centres != Buffer::None)
  {
    frame.counters = TraceLattice(scene, camera, kCentres, frame.centres, reporter, stages);
  }
  if (needs.corners != Buffer::None)
  {
    const FrameCounters corners =
      TraceLattice(scene, camera, kCorners, frame.corners, reporter, stages);
    // The other counters are of pixels.
    frame.counters.rays += corners.rays;
    frame.counters.floatCheck.Add(corners.floatCheck);
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
