// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/TradeRows.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// The target that a setting must meet.
struct TradeTarget
{
  std::optional<double> error; ///< relative to the range, in the measured share of the shown pixels
  std::optional<double> seconds;
  bool ofNext = false; ///< seconds are those of later cuts, else of the first picture
};

/// The setting that meets the target.
struct Recommendation
{
  const TradeRow* row = nullptr; ///< null: none does
  double margin = 0.0;           ///< the target divided by the setting's value; infinite: error 0
  /// Where none meets it, the setting that comes nearest.
  const TradeRow* nearest = nullptr;
};

/// Times within this factor of the shortest count as equal, because repeated runs differ by more.
inline constexpr double kAlikeTimes = 1.1;

/// With a target error: the fastest setting whose error is at most that, within the time if one is
/// given; among equal times the most accurate. Otherwise the setting with the least error within
/// the time, among equal errors the fastest. Of exact settings that differ in contours or colours
/// only, the default one.
[[nodiscard]] Recommendation Recommend(
  const std::vector<TradeRow>& rows, const TradeTarget& target, const std::array<double, 2>& range);
} // namespace pixelexact
