// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Canvas.h"

#include "Drawing/Blending.h"

#include "Core/Base/Error.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

namespace pixelexact
{
Canvas::Canvas(cairo_surface_t* surface, int width, int height, double unit, int fontSize,
  const FontChoice& font)
  : Width(width)
  , Height(height)
  , Surface(surface)
  , Context(cairo_create(surface))
  , Fonts(font)
{
  cairo_scale(Context, unit, unit);
  cairo_set_line_cap(Context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(Context, CAIRO_LINE_JOIN_ROUND);
  Fonts.Set(Context, {});
  cairo_set_font_size(Context, fontSize);
  if (const cairo_status_t status = cairo_status(Context); status != CAIRO_STATUS_SUCCESS)
  {
    cairo_destroy(Context);
    cairo_surface_destroy(Surface);
    throw Error(std::string("cairo: ") + cairo_status_to_string(status));
  }
}

Canvas::~Canvas()
{
  cairo_destroy(Context);
  cairo_surface_destroy(Surface);
}

void Canvas::SetColor(const Rgba& color)
{
  cairo_set_source_rgba(
    Context, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, color[3] / 255.0);
}

void Canvas::MoveOrigin(int x, int y)
{
  cairo_translate(Context, x, -y);
  Origin = { Origin[0] + x, Origin[1] + y };
}

void Canvas::Fill(int x, int y, int width, int height, const Rgba& color)
{
  SetColor(color);
  cairo_rectangle(Context, x, Down(y + height), width, height);
  // Without anti-aliasing no background shows between the rows of a bar.
  cairo_set_antialias(Context, CAIRO_ANTIALIAS_NONE);
  cairo_fill(Context);
  cairo_set_antialias(Context, CAIRO_ANTIALIAS_DEFAULT);
}

void Canvas::AddPath(std::span<const CanvasPoint> points)
{
  // Starts a new path instead of continuing after the last text.
  cairo_new_path(Context);
  for (const CanvasPoint& point : points)
  {
    cairo_line_to(Context, point[0], Down(point[1]));
  }
  if (points.size() > 2 && points.front() == points.back())
  {
    cairo_close_path(Context);
  }
}

void Canvas::FillPolygon(std::span<const CanvasPoint> points, const Rgba& color)
{
  SetColor(color);
  AddPath(points);
  cairo_close_path(Context);
  cairo_fill(Context);
}

void Canvas::Line(std::span<const CanvasPoint> points, double width, const Rgba& color)
{
  if (points.empty())
  {
    return;
  }
  SetColor(color);
  cairo_set_line_width(Context, width);
  AddPath(points);
  cairo_stroke(Context);
}

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

void Canvas::Write(
  const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color)
{
  const std::string valid = ValidUtf8(text);
  const double part = anchor == TextAnchor::Left ? 0.0 : anchor == TextAnchor::Right ? 1.0 : 0.5;
  const double left = x - part * Fonts.WidthOf(Context, valid);
  SetColor(color);
  Fonts.Write(Context, valid, left, Down(y));
}

void Canvas::WriteWithin(
  const std::string& text, double x, double y, TextAnchor anchor, double room, const Rgba& color)
{
  const double size = FontSize();
  if (const double width = WidthOf(text); width > room)
  {
    cairo_set_font_size(Context, size * std::max(room, 1.0) / width);
  }
  Write(text, x, y, anchor, color);
  cairo_set_font_size(Context, size);
}

double Canvas::FontSize() const
{
  cairo_matrix_t font;
  cairo_get_font_matrix(Context, &font);
  return font.xx;
}

void Canvas::WriteTurned(const std::string& text, const CanvasPoint& at, double angle, int fontSize,
  const Rgba& color, const Rgba& halo)
{
  constexpr double kHaloWidth = 0.25; // of the font's size, both sides together
  cairo_save(Context);
  cairo_translate(Context, at[0], Down(at[1]));
  cairo_rotate(Context, -angle * std::numbers::pi / 180.0);
  const double size = fontSize > 0 ? fontSize : FontSize();
  cairo_set_font_size(Context, size);
  const std::string valid = ValidUtf8(text);
  const double left = -0.5 * Fonts.WidthOf(Context, valid);
  if (halo[3] > 0)
  {
    SetColor(halo);
    cairo_set_line_width(Context, kHaloWidth * size);
    Fonts.AddOutline(Context, valid, left, 0.0);
    cairo_stroke(Context);
  }
  SetColor(color);
  Fonts.Write(Context, valid, left, 0.0);
  cairo_restore(Context);
}

double Canvas::WidthOf(const std::string& text)
{
  return Fonts.WidthOf(Context, ValidUtf8(text));
}

std::vector<std::string> Canvas::Wrapped(const std::string& text, double room)
{
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);)
  {
    std::istringstream words(paragraph);
    std::string line;
    for (std::string word; words >> word;)
    {
      std::string longer = line;
      longer.append(line.empty() ? "" : " ").append(word);
      if (!line.empty() && WidthOf(longer) > room)
      {
        lines.push_back(std::exchange(line, word));
      }
      else
      {
        line = std::move(longer);
      }
    }
    lines.push_back(line);
  }
  return lines;
}

std::string Canvas::Shortened(const std::string& text, double room)
{
  std::string shown = ValidUtf8(text);
  while (shown.size() > 3 && WidthOf(shown) > room)
  {
    // A letter may have several bytes, whose further ones begin with the bits 10.
    std::size_t end = shown.size() - (shown.ends_with("...") ? 4 : 1);
    while (end > 0 && (static_cast<unsigned char>(shown[end]) & 0xc0U) == 0x80U)
    {
      --end;
    }
    shown.replace(end, std::string::npos, "...");
  }
  return shown;
}

void Canvas::Clip(int width, int height)
{
  cairo_save(Context);
  cairo_rectangle(Context, 0.0, Down(height), width, height);
  cairo_clip(Context);
}

void Canvas::Unclip()
{
  cairo_restore(Context);
}

RasterCanvas::RasterCanvas(
  int width, int height, const Rgba& background, int fontSize, const FontChoice& font)
  : Canvas(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height), width, height, 1.0,
      fontSize, font)
  , Transparent(background[3] == 0)
  , Colors(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{
  for (std::size_t i = 0; i < Colors.size(); i += 4)
  {
    std::ranges::copy(background, &Colors[i]);
  }
}

void RasterCanvas::Place(const Image& picture)
{
  const std::size_t row =
    static_cast<std::size_t>(picture.channels) * static_cast<std::size_t>(picture.width);
  const int columns = std::min(picture.width, Width - Origin[0]);
  for (int j = 0; j < std::min(picture.height, Height - Origin[1]); ++j)
  {
    const std::uint8_t* from = &picture.pixels[static_cast<std::size_t>(j) * row];
    std::uint8_t* to = &Colors[4 *
      (static_cast<std::size_t>(j + Origin[1]) * static_cast<std::size_t>(Width) +
        static_cast<std::size_t>(Origin[0]))];
    for (int i = 0; i < columns; ++i, from += picture.channels, to += 4)
    {
      std::copy_n(from, picture.channels, to);
      to[3] = picture.channels == 4 ? to[3] : 255;
    }
  }
}

Image RasterCanvas::Picture() const
{
  std::vector<std::uint8_t> all = Colors;
  cairo_surface_flush(Surface);
  const unsigned char* const drawn = cairo_image_surface_get_data(Surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(Surface));
  for (int j = 0; j < Height; ++j)
  {
    const unsigned char* from = drawn + stride * static_cast<std::size_t>(Height - 1 - j);
    std::uint8_t* to = &all[4 * static_cast<std::size_t>(j) * static_cast<std::size_t>(Width)];
    for (int i = 0; i < Width; ++i, from += 4, to += 4)
    {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, from, sizeof pixel);
      const std::uint32_t alpha = pixel >> 24U;
      if (alpha > 0)
      {
        const auto channel = [&](unsigned shift)
        {
          const std::uint32_t premultiplied = pixel >> shift & 0xffU;
          return static_cast<std::uint8_t>(
            std::min(255U, (premultiplied * 255U + alpha / 2U) / alpha));
        };
        BlendOver({ channel(16), channel(8), channel(0), 255 }, alpha / 255.0, to);
      }
    }
  }
  Image picture{ Width, Height, Transparent ? 4 : 3, {} };
  if (Transparent)
  {
    picture.pixels = std::move(all);
    return picture;
  }
  picture.pixels.resize(all.size() / 4 * 3);
  for (std::size_t i = 0; i < all.size() / 4; ++i)
  {
    std::copy_n(&all[4 * i], 3, &picture.pixels[3 * i]);
  }
  return picture;
}
} // namespace pixelexact
