// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/ImageFile.h"

#include "Trace/Modules/ColorMapping.h"
#include "Views/TextImages.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pixelexact
{
class Canvas;

/// Width and height of the plots that commands write beside their reports, in pixels.
inline constexpr int kPlotWidth = 1100;
inline constexpr int kPlotHeight = 720;

/// A plot of lines, points or bars over linear or logarithmic axes.
struct Plot
{
  struct Point
  {
    double x = 0.0;
    /// On a logarithmic axis 0 is drawn on the lower end, below all others, and infinity on the
    /// upper one. Lines are interrupted where a linear axis has no place for it.
    double y = 0.0;
    std::string label;
  };
  struct Series
  {
    std::string name; ///< empty: not in the legend
    Rgba color{};
    std::vector<Point> points;
    bool joined = true;
    bool dashed = false; ///< without marks, for lines to compare with
    bool marks = true;   ///< whether points are drawn
  };
  /// A bar of a histogram, from the axis to `y`; an error bar holds it.
  struct Bar
  {
    double from = 0.0;
    double to = 0.0;
    double y = 0.0;
    std::array<double, 2> range{}; ///< of y
  };
  std::string title;
  std::string across; ///< the axes' names
  std::string up;
  std::array<bool, 2> logarithmic{ false, false }; ///< across, up
  std::vector<Series> series;
  std::vector<Bar> bars;

  /// Draws on a canvas of this size, in pixels, with letters of a height of `font`.
  void DrawOn(Canvas& canvas, int width, int height, int font) const;
  /// RGB, three bytes a pixel, lower left first.
  [[nodiscard]] std::vector<std::uint8_t> Draw(int width, int height) const;
  /// The bytes of a picture or, with lines and letters as vectors, of an SVG or PDF. `file`: for
  /// messages. Throws Error where encoding fails.
  [[nodiscard]] std::string Encode(PictureFormat format, int width, int height,
    const FontChoice& font, const PictureTexts& texts, const std::string& file) const;
};

/// Colours of series, in this order, which are distinct in print and for most colour-blind readers
/// (Okabe and Ito, 2008).
Rgba SeriesColor(std::size_t number);
} // namespace pixelexact
