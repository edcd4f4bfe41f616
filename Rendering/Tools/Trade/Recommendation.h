// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/TradeRows.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// What is asked of a setting.
struct TradeTarget
{
  std::optional<double> error; ///< over the range, of so many of the shown pixels as were measured
  std::optional<double> seconds;
  bool ofNext = false; ///< of later cuts, else of the first picture
};

/// The setting that meets the target.
struct Recommendation
{
  const TradeRow* row = nullptr; ///< null: none does
  double margin = 0.0;           ///< the target over what the setting has; infinite: error 0
  /// Where none does, the one that comes nearest.
  const TradeRow* nearest = nullptr;
};

/// Times that are this much longer than the shortest are taken for alike: repeats differ by more.
inline constexpr double kAlikeTimes = 1.1;

/// With an error: the fastest that is no further off, within the time where one is given; of those
/// whose times are alike the most accurate. Else the one with the least error within the time, of
/// equals the fastest. Of exact settings whose contours or colours alone differ the usual one.
[[nodiscard]] Recommendation Recommend(
  const std::vector<TradeRow>& rows, const TradeTarget& target, const std::array<double, 2>& range);
} // namespace pixelexact
