// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/ContourTime.h"

#include "Base/Report.h"
#include "Bench/FrameTime.h"

#include <nlohmann/json.hpp>

#include <ctime>

namespace pixelexact
{
double ContourTime::Frame() const
{
  return Median(frames);
}

double ContourTime::Ratio() const
{
  return Median(Ratios(frames, plain));
}

double ContourTime::FirstRatio() const
{
  return first / Median(plain);
}

ContourTime MeasureContours(const Scene& scene, const Camera& camera, const Pipeline& without,
  const Pipeline& with, int repeat, const std::function<ContourCounters()>& pixels)
{
  ContourTime time;
  const Timer first;
  (void)Trace(scene, camera, with);
  time.first = first.Seconds();
  const auto measure =
    [&](const Pipeline& pipeline, std::vector<double>& seconds, std::vector<double>& busy)
  {
    const Timer timer;
    const std::clock_t begin = std::clock();
    (void)Trace(scene, camera, pipeline);
    busy.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    seconds.push_back(timer.Seconds());
  };
  for (int i = 0; i < repeat; ++i)
  {
    measure(without, time.plain, time.plainBusy);
    measure(with, time.frames, time.busy);
  }
  time.pixels = pixels();
  return time;
}

nlohmann::ordered_json ToJson(const ContourTime& time)
{
  return { { "first_frame_seconds", time.first }, { "frame_seconds", time.frames },
    { "frame_seconds_without", time.plain }, { "frame_processor_seconds", time.busy },
    { "frame_processor_seconds_without", time.plainBusy }, { "median_frame_seconds", time.Frame() },
    { "ratio_to_frame", time.Ratio() }, { "first_ratio_to_frame", time.FirstRatio() },
    { "in", time.pixels.in }, { "out", time.pixels.out }, { "undecided", time.pixels.undecided },
    { "jumps", time.pixels.jumps }, { "samples", time.pixels.samples },
    { "by_blocks", time.pixels.byBlocks }, { "by_edges", time.pixels.byEdges },
    { "by_parts", time.pixels.byParts } };
}

std::string Describe(const ContourTime& time)
{
  return fmt::format("{} s, {} times a frame without; the first {} s, {} times; {} pixels in, {} "
                     "undecided",
    Short(time.Frame()), Short(time.Ratio()), Short(time.first), Short(time.FirstRatio()),
    time.pixels.in, time.pixels.undecided);
}
} // namespace pixelexact
