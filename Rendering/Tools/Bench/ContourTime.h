// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ContourCertifier.h"
#include "Trace/Tracer.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace pixelexact
{
/// Times that contours add to frames. Frames with and without contours alternate, so that changes
/// of the machine's speed affect both.
struct ContourTime
{
  double first = 0.0;         ///< seconds of the first frame with them: elements are looked into
  std::vector<double> frames; ///< of later ones
  std::vector<double> plain;  ///< of one without, before each
  /// The same in seconds of processors, of all threads together.
  std::vector<double> busy;
  std::vector<double> plainBusy;
  ContourCounters pixels; ///< of a frame

  [[nodiscard]] double Frame() const;
  /// The medians of the frames' ratios to those without.
  [[nodiscard]] double Ratio() const;
  [[nodiscard]] double FirstRatio() const;
};

/// `with`: the pipeline `without` with contours, without bounds of any element; `pixels`: the
/// counts of its last frame.
ContourTime MeasureContours(const Scene& scene, const Camera& camera, const Pipeline& without,
  const Pipeline& with, int repeat, const std::function<ContourCounters()>& pixels);

nlohmann::ordered_json ToJson(const ContourTime& time);
/// A sentence.
std::string Describe(const ContourTime& time);
} // namespace pixelexact
