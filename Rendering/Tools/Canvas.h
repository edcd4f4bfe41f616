// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TextImages.h"

#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pixelexact
{
/// A point in pixels from the lower left.
using CanvasPoint = std::array<double, 2>;

/// A picture on which a figure is drawn. What leaves it is cut off.
class Canvas
{
public:
  Canvas(int width, int height, const Rgba& background, int fontSize);

  /// Opaque pixels, lower left first, three bytes each, from a place on.
  void Place(const std::vector<std::uint8_t>& rgb, int width, int height, int x, int y);
  void Fill(int x, int y, int width, int height, const Rgba& color);
  /// The outline of the same, a pixel wide and around it.
  void Frame(int x, int y, int width, int height, const Rgba& color);
  /// With smooth borders.
  void Line(const CanvasPoint& from, const CanvasPoint& to, double width, const Rgba& color);
  void Write(const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color);
  [[nodiscard]] double WidthOf(const std::string& text) { return Texts.SizeOf(text).width; }

  /// Three bytes a pixel, lower left first.
  [[nodiscard]] std::vector<std::uint8_t> Pixels() const;

private:
  [[nodiscard]] std::uint8_t* At(int x, int y);

  int Width;
  int Height;
  std::vector<std::uint8_t> Colors;
  TextImages Texts;
};
} // namespace pixelexact
