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
/// Paints values in the map's colours, contours in black, unknown pixels in magenta, and the
/// background elsewhere.
[[nodiscard]] std::vector<std::uint8_t> PaintValues(
  const Picture& picture, const ColorMap& map, const Rgba& background);

/// The range of relative errors in PaintErrors.
inline constexpr std::array<double, 2> kPaintedErrors{ 1e-8, 1.0 };

/// Paints the logarithm of |error| / `range` by `map`, which spans kPaintedErrors; missing values
/// in magenta, invented ones in cyan.
[[nodiscard]] std::vector<std::uint8_t> PaintErrors(const Picture& truth, const Picture& picture,
  const std::array<double, 2>& range, const ColorMap& map, const Rgba& background);

/// The facts of a report in addition to its rows.
struct TradeFacts
{
  std::vector<std::pair<std::string, std::string>> lines; ///< names and values of the scene
  std::array<double, 2> range{};
  double share = 0.99;
  int bins = 256;
  bool ofNext = false;        ///< plots show the times of later cuts
  std::string recommendation; ///< empty: no target was given
  std::string script;         ///< the file that makes the recommended linear surface; empty: none
  std::string command;        ///< reproduces the report
};

/// Writes the plots, the exact picture, and each setting's picture and picture of errors into a
/// folder, and report.html, which contains them all and needs no other file. Throws Error where a
/// file cannot be written.
void WriteTradeReport(const std::string& folder, const TradeScene& scene, const Picture& truth,
  const std::vector<TradeRow>& rows, const TradeFacts& facts, const Rgba& background);

/// Plots the error in the share of the shown pixels against the time, both axes logarithmic.
[[nodiscard]] std::vector<std::uint8_t> DrawPareto(
  const std::vector<TradeRow>& rows, const TradeFacts& facts, int width, int height);
/// Plots the mean error against the spacing, with lines of second order.
[[nodiscard]] std::vector<std::uint8_t> DrawConvergence(
  const std::vector<TradeRow>& rows, const TradeFacts& facts, int width, int height);
} // namespace pixelexact
