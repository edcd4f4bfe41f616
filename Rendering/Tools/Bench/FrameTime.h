// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace pixelexact
{
/// Measures time from its construction on.
class Timer
{
public:
  [[nodiscard]] double Seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
  }

private:
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};

double Median(std::vector<double> values);
/// The ratios times[k] / others[k].
std::vector<double> Ratios(const std::vector<double>& times, const std::vector<double>& others);

/// Times of a scene's frames and of the bare kernel on as many points. Frames and kernel alternate,
/// so that changes of the machine's speed affect both.
struct FrameTime
{
  std::int64_t points = 0;     ///< located and evaluated in one frame
  std::vector<double> frames;  ///< seconds each, on all threads
  std::vector<double> busy;    ///< processor seconds of each frame, over all threads
  std::vector<double> kernels; ///< seconds of the kernel after each frame
  StageTimes stages{};         ///< of one more frame, with its stages timed, summed over threads
  double staged = 0.0;         ///< seconds of that frame, colours included
  PrecisionCheck floatCheck{}; ///< of one frame

  [[nodiscard]] double Frame() const;
  [[nodiscard]] double Kernel() const;
  /// The median of the frames' ratios to the kernel after each; 0 without points.
  [[nodiscard]] double Ratio() const;
};

/// Measures `repeat` frames with a pipeline, after one that is not counted; `done` receives the
/// progress from 0 to 1.
FrameTime MeasureFrames(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  int repeat, const std::function<void(double)>& done);

/// The seconds of each stage.
nlohmann::ordered_json ToJson(const StageTimes& stages);
/// Shares of the stages' total time, such as "inversion 61 %, evaluation 12 %, ...", the largest
/// first. Stages below one percent are left out.
std::string Shares(const StageTimes& stages);
} // namespace pixelexact
