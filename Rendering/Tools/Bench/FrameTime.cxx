// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/FrameTime.h"

#include "Base/Report.h"
#include "Bench/KernelTime.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr const char* kNames[kStages] = { "rays and hits", "candidates", "bounds", "inversion",
  "evaluation", "careful path", "writing", "colours" };
} // namespace

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::vector<double> Ratios(const std::vector<double>& times, const std::vector<double>& others)
{
  std::vector<double> ratios(times.size());
  std::transform(
    times.begin(), times.end(), others.begin(), ratios.begin(), std::divides<double>());
  return ratios;
}

double FrameTime::Frame() const
{
  return Median(frames);
}

double FrameTime::Kernel() const
{
  return Median(kernels);
}

double FrameTime::Ratio() const
{
  if (points == 0)
  {
    return 0.0;
  }
  return Median(Ratios(frames, kernels));
}

FrameTime MeasureFrames(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  int repeat, const std::function<void(double)>& done)
{
  FrameTime time;
  Frame pixels = Trace(scene, camera, pipeline);
  time.points = pixels.counters.exact;
  time.floatCheck = pixels.counters.floatCheck;
  for (int i = 0; i < repeat; ++i)
  {
    const Timer frame;
    const std::clock_t begin = std::clock();
    pixels = Trace(scene, camera, pipeline, {}, {}, nullptr, std::move(pixels));
    time.busy.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    time.frames.push_back(frame.Seconds());
    time.kernels.push_back(KernelSeconds(scene.layers.front().field->values, time.points));
    done(static_cast<double>(i + 1) / (repeat + 1));
  }
  const Timer frame;
  (void)Trace(scene, camera, pipeline, {}, {}, &time.stages, std::move(pixels));
  time.staged = frame.Seconds();
  done(1.0);
  return time;
}

nlohmann::ordered_json ToJson(const StageTimes& stages)
{
  nlohmann::ordered_json object;
  for (std::size_t k = 0; k < kStages; ++k)
  {
    object[kNames[k]] = stages[k];
  }
  return object;
}

std::string Shares(const StageTimes& stages)
{
  const double total = std::accumulate(stages.begin(), stages.end(), 0.0);
  std::vector<std::size_t> order(kStages);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&stages](std::size_t a, std::size_t b) { return stages[a] > stages[b]; });
  std::vector<std::string> shares;
  for (const std::size_t k : order)
  {
    const auto percent = total > 0.0 ? std::lround(100.0 * stages[k] / total) : 0;
    if (percent > 0)
    {
      shares.push_back(fmt::format("{} {} %", kNames[k], percent));
    }
  }
  return Listed(shares);
}
} // namespace pixelexact
