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
/// From its beginning on.
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
/// Of each of as many times to its other.
std::vector<double> Ratios(const std::vector<double>& times, const std::vector<double>& others);

/// What frames of a scene cost, beside the bare kernel on as many points. Frames and kernel take
/// turns, so that a machine whose speed changes changes both.
struct FrameTime
{
  std::int64_t points = 0;     ///< located and evaluated in one frame
  std::vector<double> frames;  ///< seconds each, on all threads
  std::vector<double> busy;    ///< seconds of processors for each frame, of all threads together
  std::vector<double> kernels; ///< seconds of the kernel after each
  StageTimes stages{};         ///< of one more frame, with its stages timed, summed over threads
  double staged = 0.0;         ///< seconds of that frame, colours and all
  PrecisionCheck floatCheck{}; ///< of one frame

  [[nodiscard]] double Frame() const;
  [[nodiscard]] double Kernel() const;
  /// The median of the frames' ratios to the kernel after each; 0 without points.
  [[nodiscard]] double Ratio() const;
};

/// `repeat` frames with a pipeline, after one that is not counted; `done` receives the part done.
FrameTime MeasureFrames(const Scene& scene, const Camera& camera, const Pipeline& pipeline,
  int repeat, const std::function<void(double)>& done);

/// Seconds of each stage.
nlohmann::ordered_json ToJson(const StageTimes& stages);
/// "inversion 61 %, evaluation 12 %, ...", of what all stages take, the largest first; stages below
/// a percent are left out.
std::string Shares(const StageTimes& stages);
} // namespace pixelexact
