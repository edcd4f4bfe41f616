// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/TradeRun.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// Seconds of repeated runs, and their ratios to the exact picture's seconds in the same repeats.
struct TradeSeconds
{
  std::vector<double> times;
  std::vector<double> exact;

  [[nodiscard]] double Median() const;
  /// The median of the ratios.
  [[nodiscard]] double Ratio() const;
};

/// The results of a setting.
struct TradeRow
{
  TradeSetting setting;
  TradeSeconds first;
  TradeSeconds next;
  double bytes = -1.0; ///< largest of all repeats; less than 0: unknown
  std::size_t triangles = 0;
  std::optional<double> proven; ///< TradeRun::ProvenChange
  PictureErrors errors;
  std::int64_t unknown = 0; ///< pixels
  Picture picture;
  std::string refused; ///< reason why there is no picture; empty: there is one

  [[nodiscard]] bool IsThere() const { return refused.empty(); }
};

/// Times all settings in turn, so that changes of the machine's speed affect all alike, and
/// compares their pictures with `truth`. A first turn is not counted. The first setting is the
/// exact picture. `done` receives the progress from 0 to 1.
[[nodiscard]] std::vector<TradeRow> MeasureTrade(const TradeScene& scene,
  const std::vector<TradeSetting>& settings, const Picture& truth, const ErrorMeasure& measure,
  int repeat, const std::function<void(double)>& done);

/// The order of convergence of a family's mean error in its spacing.
struct TradeOrder
{
  TradeFamily family;
  double overall; ///< the slope of the logarithms, by least squares
  double last;    ///< between the two finest
  int settings;   ///< number of settings used
};
/// The orders of families with at least three settings whose mean error is above a millionth of the
/// range. Smaller errors may be roundings of VTK's points, which are floats.
[[nodiscard]] std::vector<TradeOrder> OrdersOf(
  const std::vector<TradeRow>& rows, const std::array<double, 2>& range);

/// An error relative to the range.
[[nodiscard]] double Relative(double error, const std::array<double, 2>& range);

/// A line of names, and one for each row: errors relative to the range, seconds, bytes; unknown
/// fields are empty.
[[nodiscard]] std::string ToCsv(
  const std::vector<TradeRow>& rows, const std::array<double, 2>& range);
} // namespace pixelexact
