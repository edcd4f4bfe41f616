// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/CairoFonts.h"
#include "Drawing/Image.h"

#include "Views/TextImages.h"

#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace pixelexact
{
/// A point in pixels from the lower left.
using CanvasPoint = std::array<double, 2>;

/// A picture on which a figure is drawn, in pixels. Parts outside of it are clipped.
class Canvas
{
public:
  Canvas() = default;
  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Puts a picture into the lower left corner.
  virtual void Place(const Image& picture) = 0;
  virtual void Fill(int x, int y, int width, int height, const Rgba& color) = 0;
  /// Draws a line through all points, with anti-aliasing and round ends.
  virtual void Line(std::span<const CanvasPoint> points, double width, const Rgba& color) = 0;
  virtual void Write(
    const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color) = 0;
  [[nodiscard]] virtual double WidthOf(const std::string& text) = 0;

  void Line(const CanvasPoint& from, const CanvasPoint& to, double width, const Rgba& color);
  /// Draws an outline, one pixel wide, around the rectangle of Fill.
  void Frame(int x, int y, int width, int height, const Rgba& color);
};

/// A canvas of pixels.
class RasterCanvas final : public Canvas
{
public:
  /// The canvas is transparent where the background is.
  RasterCanvas(int width, int height, const Rgba& background, int fontSize, const FontChoice& font);

  using Canvas::Line;
  void Place(const Image& picture) override;
  void Fill(int x, int y, int width, int height, const Rgba& color) override;
  void Line(std::span<const CanvasPoint> points, double width, const Rgba& color) override;
  void Write(
    const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color) override;
  [[nodiscard]] double WidthOf(const std::string& text) override;

  /// The picture; four channels where the background is transparent.
  [[nodiscard]] Image Picture() const;

private:
  [[nodiscard]] std::uint8_t* At(int x, int y);
  void Segment(const CanvasPoint& from, const CanvasPoint& to, double width, const Rgba& color);
  /// Writes a text with letters beyond ASCII.
  void WriteLetters(
    const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color);

  int Width;
  int Height;
  bool Transparent;
  std::vector<std::uint8_t> Colors;
  int FontSize;
  TextImages Texts;   ///< for ASCII, with VTK's fonts
  CairoFonts Letters; ///< for other letters
};
} // namespace pixelexact
