// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options.h"

#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// How values become colours, and what is behind them.
class ColorOptions
{
public:
  void AddTo(CLI::App& command);

  /// Throws UsageError for what the command line alone shows to be wrong.
  void Check() const;

  /// The range given, else that of the frame's exact values (with --log of the positive ones);
  /// [0, 1], or [1, 10] with --log, where there is none. `layers`: those that count; empty: all.
  [[nodiscard]] std::array<double, 2> RangeFor(
    const Frame& frame, const std::vector<bool>& layers = {}) const;
  /// `map`: another map than that of all layers. Throws UsageError where there is no such map.
  [[nodiscard]] ColorMap MapOver(
    const std::array<double, 2>& range, const std::optional<std::string>& map = {}) const;

  /// The frame's colours in front of the background, RGB.
  [[nodiscard]] std::vector<std::uint8_t> Flatten(const Frame& frame) const;

private:
  std::string Map = "viridis";
  std::vector<double> Range;
  bool Log = false;
  std::vector<double> NanColor;
  std::vector<double> Background{ 1.0, 1.0, 1.0 };
};

/// Throws UsageError where there is no such colour map.
void CheckMap(const char* option, const std::string& map);

/// Throws UsageError where an option's red, green or blue is not within 0 to 1.
void CheckColor(const char* option, const std::vector<double>& color);

/// The smallest and largest finite value of the exact pixels, what is seen through others included,
/// of those above `lowest` and on these layers (empty: all); none: empty.
std::optional<std::array<double, 2>> ValueRange(
  const Frame& frame, double lowest, const std::vector<bool>& layers = {});
} // namespace pixelexact
