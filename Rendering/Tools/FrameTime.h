// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Tracer.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace pixelexact
{
/// What frames of a scene cost, beside the bare kernel on as many points. Frames and kernel take
/// turns, so that a machine whose speed changes changes both.
struct FrameTime
{
  std::int64_t points = 0;     ///< located and evaluated in one frame
  std::vector<double> frames;  ///< seconds each, on all threads
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
