// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/StridedFrame.h"

#include "Trace/BufferTable.h"
#include "Trace/FrameTiles.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pixelexact
{
namespace
{
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

/// By verdict, of the pixels.
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
} // namespace

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
