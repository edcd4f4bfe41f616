// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/TradeRun.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
/// Seconds of repeats, and their ratios to those of the exact picture of the same repeats.
struct TradeSeconds
{
  std::vector<double> times;
  std::vector<double> exact;

  [[nodiscard]] double Median() const;
  /// The median of the ratios.
  [[nodiscard]] double Ratio() const;
};

/// What is known of a setting.
struct TradeRow
{
  TradeSetting setting;
  TradeSeconds first;
  TradeSeconds next;
  double bytes = -1.0; ///< the most of all repeats; less than 0: not known
  std::size_t triangles = 0;
  std::optional<double> proven; ///< TradeRun::ProvenChange
  PictureErrors errors;
  std::int64_t unknown = 0; ///< pixels
  Picture picture;
  std::string refused; ///< why there is no picture; empty: there is one

  [[nodiscard]] bool IsThere() const { return refused.empty(); }
};

/// Times all settings, turn by turn, so that a machine whose speed changes changes all alike, and
/// compares their pictures with `truth`. A turn before them all is not counted. The first setting
/// is the exact picture. `done` receives the part done.
[[nodiscard]] std::vector<TradeRow> MeasureTrade(const TradeScene& scene,
  const std::vector<TradeSetting>& settings, const Picture& truth, const ErrorMeasure& measure,
  int repeat, const std::function<void(double)>& done);

/// The order of convergence of a family's mean error in its spacing.
struct TradeOrder
{
  TradeFamily family;
  double overall; ///< the slope of the logarithms, by least squares
  double last;    ///< between the two finest
  int settings;   ///< that it is made of
};
/// Of families with three settings and more whose mean error is above a millionth of the range:
/// below, it may be the rounding of VTK's points, which are floats.
[[nodiscard]] std::vector<TradeOrder> OrdersOf(
  const std::vector<TradeRow>& rows, const std::array<double, 2>& range);

/// Errors as parts of the range.
[[nodiscard]] double Relative(double error, const std::array<double, 2>& range);

/// A line of names, and one for each row; errors over the range, seconds, bytes; empty where
/// something is not known.
[[nodiscard]] std::string ToCsv(
  const std::vector<TradeRow>& rows, const std::array<double, 2>& range);
} // namespace pixelexact
