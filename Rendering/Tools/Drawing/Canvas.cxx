// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Canvas.h"

#include "Drawing/Blending.h"

#include <algorithm>
#include <cmath>

namespace pixelexact
{
void Canvas::Line(const CanvasPoint& from, const CanvasPoint& to, double width, const Rgba& color)
{
  Line(std::array{ from, to }, width, color);
}

void Canvas::Frame(int x, int y, int width, int height, const Rgba& color)
{
  Fill(x - 1, y - 1, width + 2, 1, color);
  Fill(x - 1, y + height, width + 2, 1, color);
  Fill(x - 1, y, 1, height, color);
  Fill(x + width, y, 1, height, color);
}

RasterCanvas::RasterCanvas(
  int width, int height, const Rgba& background, int fontSize, const FontChoice& font)
  : Width(width)
  , Height(height)
  , Transparent(background[3] == 0)
  , Colors(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
  , FontSize(fontSize)
  , Texts(fontSize, font)
  , Letters(font)
{
  Fill(0, 0, width, height, background);
}

std::uint8_t* RasterCanvas::At(int x, int y)
{
  return x >= 0 && x < Width && y >= 0 && y < Height
    ? &Colors[4 *
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(Width) +
          static_cast<std::size_t>(x))]
    : nullptr;
}

void RasterCanvas::Place(const Image& picture)
{
  auto from = picture.pixels.begin();
  for (int j = 0; j < picture.height; ++j)
  {
    for (int i = 0; i < picture.width; ++i, from += picture.channels)
    {
      if (std::uint8_t* to = At(i, j))
      {
        std::copy_n(from, picture.channels, to);
        to[3] = picture.channels == 4 ? to[3] : 255;
      }
    }
  }
}

void RasterCanvas::Fill(int x, int y, int width, int height, const Rgba& color)
{
  for (int j = y; j < y + height; ++j)
  {
    for (int i = x; i < x + width; ++i)
    {
      if (std::uint8_t* to = At(i, j))
      {
        std::ranges::copy(color, to);
      }
    }
  }
}

void RasterCanvas::Line(std::span<const CanvasPoint> points, double width, const Rgba& color)
{
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    Segment(points[i - 1], points[i], width, color);
  }
}

void RasterCanvas::Segment(
  const CanvasPoint& from, const CanvasPoint& to, double width, const Rgba& color)
{
  const double dx = to[0] - from[0];
  const double dy = to[1] - from[1];
  const double square = dx * dx + dy * dy;
  const double reach = 0.5 * width + 1.0;
  const auto first = [reach](double a, double b)
  { return static_cast<int>(std::floor(std::min(a, b) - reach)); };
  const auto last = [reach](double a, double b)
  { return static_cast<int>(std::ceil(std::max(a, b) + reach)); };
  for (int y = first(from[1], to[1]); y <= last(from[1], to[1]); ++y)
  {
    for (int x = first(from[0], to[0]); x <= last(from[0], to[0]); ++x)
    {
      std::uint8_t* pixel = At(x, y);
      if (pixel == nullptr)
      {
        continue;
      }
      const double px = x + 0.5 - from[0];
      const double py = y + 0.5 - from[1];
      const double s = square > 0.0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
      const double away = std::hypot(px - s * dx, py - s * dy);
      const double part = std::clamp(0.5 * width + 0.5 - away, 0.0, 1.0);
      BlendOver(color, part, pixel);
    }
  }
}

void RasterCanvas::Write(
  const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color)
{
  if (IsAscii(text))
  {
    Texts.Put(text, x, y, anchor, color, 0.0, { Width, Height, Colors.data() });
  }
  else
  {
    WriteLetters(ValidUtf8(text), x, y, anchor, color);
  }
}

void RasterCanvas::WriteLetters(
  const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color)
{
  const double width = WidthOf(text);
  const int border = FontSize;
  const int columns = static_cast<int>(std::ceil(width)) + 2 * border;
  const int rows = 3 * FontSize;
  cairo_surface_t* mask = cairo_image_surface_create(CAIRO_FORMAT_A8, columns, rows);
  cairo_t* context = cairo_create(mask);
  cairo_set_font_size(context, FontSize);
  Letters.Write(context, text, border, 0.5 * rows);
  cairo_destroy(context);
  cairo_surface_flush(mask);
  const double left = x -
    (anchor == TextAnchor::Left       ? 0.0
        : anchor == TextAnchor::Right ? width
                                      : 0.5 * width);
  const int x0 = static_cast<int>(std::lround(left)) - border;
  const int y0 = static_cast<int>(std::lround(y + 0.5 * rows)) - 1;
  const unsigned char* parts = cairo_image_surface_get_data(mask);
  const int stride = cairo_image_surface_get_stride(mask);
  for (int j = 0; parts != nullptr && j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      std::uint8_t* pixel = At(x0 + i, y0 - j);
      if (const unsigned char part = parts[j * stride + i]; pixel != nullptr && part > 0)
      {
        BlendOver(color, part / 255.0, pixel);
      }
    }
  }
  cairo_surface_destroy(mask);
}

double RasterCanvas::WidthOf(const std::string& text)
{
  if (IsAscii(text))
  {
    return Texts.SizeOf(text).width;
  }
  cairo_surface_t* none = cairo_image_surface_create(CAIRO_FORMAT_A8, 0, 0);
  cairo_t* context = cairo_create(none);
  cairo_set_font_size(context, FontSize);
  const double width = Letters.WidthOf(context, ValidUtf8(text));
  cairo_destroy(context);
  cairo_surface_destroy(none);
  return width;
}

Image RasterCanvas::Picture() const
{
  Image picture{ Width, Height, Transparent ? 4 : 3, {} };
  if (Transparent)
  {
    picture.pixels = Colors;
    return picture;
  }
  picture.pixels.resize(Colors.size() / 4 * 3);
  for (std::size_t i = 0; i < Colors.size() / 4; ++i)
  {
    std::copy_n(&Colors[4 * i], 3, &picture.pixels[3 * i]);
  }
  return picture;
}
} // namespace pixelexact
