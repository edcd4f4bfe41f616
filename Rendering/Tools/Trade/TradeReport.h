// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Compare/PictureErrors.h"
#include "Trace/Modules/ColorMapping.h"
#include "Trade/Recommendation.h"
#include "Trade/TradeRows.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Pictures of values and of errors; RGB, three bytes a pixel, lower left first.
namespace pixelexact
{
/// Values in the map's colours, contours in black, unknown pixels in magenta, the background where
/// there is nothing.
[[nodiscard]] std::vector<std::uint8_t> PaintValues(
  const Picture& picture, const ColorMap& map, const Rgba& background);

/// The error's range in PaintErrors, over the values' range.
inline constexpr std::array<double, 2> kPaintedErrors{ 1e-8, 1.0 };

/// The logarithm of |error| over `range` by `map`, which spans kPaintedErrors; missing values in
/// magenta, invented ones in cyan.
[[nodiscard]] std::vector<std::uint8_t> PaintErrors(const Picture& truth, const Picture& picture,
  const std::array<double, 2>& range, const ColorMap& map, const Rgba& background);

/// What a report tells beside its rows.
struct TradeFacts
{
  std::vector<std::pair<std::string, std::string>> lines; ///< of the scene: names and values
  std::array<double, 2> range{};
  double share = 0.99;
  int bins = 256;
  bool ofNext = false;        ///< plots show the times of later cuts
  std::string recommendation; ///< empty: none was asked for
  std::string script;         ///< the file that makes the recommended linear surface; or empty
  std::string command;        ///< that makes it all again
};

/// Writes the plots, the exact picture, and of each setting its picture and that of its errors into
/// a folder, and report.html, which holds them all and needs no other file. Throws Error where a
/// file cannot be written.
void WriteTradeReport(const std::string& folder, const TradeScene& scene, const Picture& truth,
  const std::vector<TradeRow>& rows, const TradeFacts& facts, const Rgba& background);

/// The error of so many of the shown pixels against the time, both axes logarithmic.
[[nodiscard]] std::vector<std::uint8_t> DrawPareto(
  const std::vector<TradeRow>& rows, const TradeFacts& facts, int width, int height);
/// The mean error against the spacing, with lines of second order.
[[nodiscard]] std::vector<std::uint8_t> DrawConvergence(
  const std::vector<TradeRow>& rows, const TradeFacts& facts, int width, int height);
} // namespace pixelexact
