// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"
#include "Trace/Modules/ContourCertifier.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <vector>

// Reports on contours.
namespace pixelexact
{
class ShotAppearance;
class Table;

/// Results of a frame's contours.
struct FoundContours
{
  std::vector<std::vector<double>> values; ///< by layer, in ascending order
  std::size_t outside = 0; ///< values outside of their layer's range at pixels' centres
  ContourCounters pixels;
  std::optional<int> labels; ///< number of labels drawn, where requested
  bool interior = false;     ///< whether loops inside of pixels were searched for
  /// Whether a count of values was requested on a surface with one value, up to rounding.
  bool ofOneValue = false;
};

/// The results of a frame after the painter's pipeline. `labels`: number of labels drawn, where
/// requested.
[[nodiscard]] FoundContours FindContours(
  const ShotAppearance& appearance, const Frame& frame, std::optional<int> labels);

/// The number of values of all layers.
[[nodiscard]] std::size_t CountOf(const FoundContours& contours);

[[nodiscard]] nlohmann::ordered_json ToJson(const FoundContours& contours);
void AddContours(Table& table, const FoundContours& contours);
} // namespace pixelexact
