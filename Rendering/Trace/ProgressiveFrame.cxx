// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/ProgressiveFrame.h"

#include "Trace/TraceLattice.h"

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

template <class T>
void SpreadBlocks(std::vector<T>& buffer, std::size_t width, std::size_t step)
{
  const std::size_t height = buffer.empty() ? 0 : buffer.size() / width;
  for (std::size_t y = 0; y < height; ++y)
  {
    for (std::size_t x = 0; x < width; ++x)
    {
      buffer[y * width + x] = buffer[(y - y % step) * width + (x - x % step)];
    }
  }
}
} // namespace

ProgressiveFrame::ProgressiveFrame(Scene scene, const Camera& camera, Buffer centres)
  : TheScene(std::move(scene))
  , TheCamera(camera)
{
  RequireTraceable(TheScene, { .centres = centres });
  TheFrame.width = camera.Width();
  TheFrame.height = camera.Height();
  TheFrame.centres.Allocate(centres, TheFrame.width, TheFrame.height);
}

bool ProgressiveFrame::Refine(const Progress& progress)
{
  return Known == 1 || Pass(Known == 0 ? kCoarsest : Known / 2, progress);
}

bool ProgressiveFrame::Complete(const Progress& progress)
{
  return Known == 1 || Pass(1, progress);
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
  FrameCounters counted;
  for (const SampleLattice& lattice : lattices)
  {
    AddCounters(
      TraceLattice(TheScene, TheCamera, lattice, TheFrame.centres, reporter, nullptr), counted);
  }
  TheFrame.counters.seconds +=
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double seconds = TheFrame.counters.seconds;
  TheFrame.counters = Finished;
  AddCounters(counted, TheFrame.counters);
  TheFrame.counters.seconds = seconds;
  if (reporter.IsAborted())
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
    const auto width = static_cast<std::size_t>(frame.width);
    const auto step = static_cast<std::size_t>(Known);
    SampleBuffers& buffers = frame.centres;
    SpreadBlocks(buffers.value, width, step);
    SpreadBlocks(buffers.position, width, step);
    SpreadBlocks(buffers.normal, width, step);
    SpreadBlocks(buffers.xi, width, step);
    SpreadBlocks(buffers.element, width, step);
    SpreadBlocks(buffers.depth, width, step);
    SpreadBlocks(buffers.verdict, width, step);
    SpreadBlocks(buffers.owners, width, step);
    SpreadBlocks(buffers.coverage, width, step);
    SpreadBlocks(buffers.valueLower, width, step);
    SpreadBlocks(buffers.valueUpper, width, step);
  }
  return frame;
}
} // namespace pixelexact
