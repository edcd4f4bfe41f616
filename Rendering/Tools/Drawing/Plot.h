// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pixelexact
{
/// A plot with logarithmic axes.
struct LogPlot
{
  struct Point
  {
    double x = 0.0;
    double y = 0.0; ///< 0 is drawn on the lower end, below all others, infinity on the upper one
    std::string label;
  };
  struct Series
  {
    std::string name; ///< empty: not in the legend
    Rgba color{};
    std::vector<Point> points;
    bool joined = true;
    bool dashed = false; ///< without marks, for lines to compare with
  };
  std::string title;
  std::string across; ///< the axes' names
  std::string up;
  std::vector<Series> series;

  /// RGB, three bytes a pixel, lower left first.
  [[nodiscard]] std::vector<std::uint8_t> Draw(int width, int height) const;
};
} // namespace pixelexact
