// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Frame.h"
#include "Trace/Modules/ContourCertifier.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <vector>

// What reports tell of contours.
namespace pixelexact
{
class ShotAppearance;
class Table;

/// What there is to tell of contours.
struct FoundContours
{
  std::vector<std::vector<double>> values; ///< by layer, in ascending order
  std::size_t outside = 0; ///< of them, outside of the values at centres of their layer's pixels
  ContourCounters pixels;
  std::optional<int> labels; ///< written, where they were asked for
  bool interior = false;     ///< whether loops inside of pixels were looked for
  /// Whether a number of values was asked for where a surface shows one value, up to rounding.
  bool ofOneValue = false;
};

/// Of a frame that the painter's pipeline ran over. `labels`: how many were written, where they
/// were asked for.
[[nodiscard]] FoundContours FindContours(
  const ShotAppearance& appearance, const Frame& frame, std::optional<int> labels);

/// Values, of all layers.
[[nodiscard]] std::size_t CountOf(const FoundContours& contours);

[[nodiscard]] nlohmann::ordered_json ToJson(const FoundContours& contours);
void AddContours(Table& table, const FoundContours& contours);
} // namespace pixelexact
