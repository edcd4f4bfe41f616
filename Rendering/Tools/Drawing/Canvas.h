// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/CairoFonts.h"
#include "Drawing/Image.h"

#include "Views/TextImages.h"

#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pixelexact
{
/// A point in pixels from the lower left.
using CanvasPoint = std::array<double, 2>;

/// A picture on which a figure is drawn, in pixels, by cairo. Parts outside of it are clipped.
class Canvas
{
public:
  virtual ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Puts a picture with its lower left corner at the origin.
  virtual void Place(const Image& picture) = 0;
  /// Moves the origin of all further coordinates, which is the canvas's lower left corner at first.
  void MoveOrigin(int x, int y);
  void Fill(int x, int y, int width, int height, const Rgba& color);
  void FillPolygon(std::span<const CanvasPoint> points, const Rgba& color);
  /// Draws a line through all points, with anti-aliasing and round ends.
  void Line(std::span<const CanvasPoint> points, double width, const Rgba& color);
  void Line(const CanvasPoint& from, const CanvasPoint& to, double width, const Rgba& color);
  /// Draws an outline, one pixel wide, around the rectangle of Fill.
  void Frame(int x, int y, int width, int height, const Rgba& color);
  void Write(const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color);
  /// The same in letters that are small enough for the text to be no wider than `room`.
  void WriteWithin(
    const std::string& text, double x, double y, TextAnchor anchor, double room, const Rgba& color);
  /// Writes a text about its middle, turned anticlockwise by an angle in degrees. `fontSize` in
  /// pixels, 0: that of the canvas. `halo`: the colour of a rim around the letters; alpha 0: none.
  void WriteTurned(const std::string& text, const CanvasPoint& at, double angle, int fontSize,
    const Rgba& color, const Rgba& halo = {});
  [[nodiscard]] double WidthOf(const std::string& text);
  /// The lines of a text, broken where it has line breaks and, at blanks, so that they are no wider
  /// than `room` where words allow it.
  [[nodiscard]] std::vector<std::string> Wrapped(const std::string& text, double room);
  /// The text, or its beginning and "..." where it is wider than `room`.
  [[nodiscard]] std::string Shortened(const std::string& text, double room);
  /// Size of letters, in pixels.
  [[nodiscard]] double FontSize() const;

  /// Draws within a rectangle alone, from the origin, until Unclip.
  void Clip(int width, int height);
  void Unclip();

protected:
  /// `surface` is owned by the canvas. `unit`: the length of a pixel on the surface. Throws Error
  /// where cairo has no memory or no font.
  Canvas(cairo_surface_t* surface, int width, int height, double unit, int fontSize,
    const FontChoice& font);

  int Width;
  int Height;
  std::array<int, 2> Origin{};
  cairo_surface_t* Surface;
  cairo_t* Context;

private:
  void SetColor(const Rgba& color);
  /// The distance of a point from the upper side, which is cairo's second coordinate.
  [[nodiscard]] double Down(double y) const { return Height - y; }
  void AddPath(std::span<const CanvasPoint> points);

  CairoFonts Fonts;
};

/// A canvas of pixels.
class RasterCanvas final : public Canvas
{
public:
  /// The largest width and height, which are cairo's.
  static constexpr int kMaxSide = 32767;

  /// The canvas is transparent where the background is. Throws Error as Canvas.
  RasterCanvas(int width, int height, const Rgba& background, int fontSize, const FontChoice& font);

  void Place(const Image& picture) override;

  /// The picture with what was drawn over it; four channels where the background is transparent.
  [[nodiscard]] Image Picture() const;

private:
  bool Transparent;
  /// Background and pictures, four channels with straight alpha. Cairo draws on a layer over it,
  /// because its own alpha is premultiplied, which would change a picture's pixels.
  std::vector<std::uint8_t> Colors;
};
} // namespace pixelexact
