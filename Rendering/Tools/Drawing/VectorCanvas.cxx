// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/VectorCanvas.h"

#include "Base/Provenance.h"
#include "Drawing/CairoFonts.h"
#include "Drawing/Picture.h"

#include "Core/Base/Error.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <sstream>

namespace pixelexact
{
namespace
{
constexpr double kPointsPerInch = 72.0;

cairo_status_t Append(void* closure, const unsigned char* data, unsigned int length)
{
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Inserts a description after the first tag of an SVG.
void AddDescription(const std::string& text, std::string& svg)
{
  pugi::xml_document document;
  document.append_child("desc").text().set(text.c_str());
  std::ostringstream description;
  document.save(description, "", pugi::format_raw | pugi::format_no_declaration);
  const auto tag = svg.find("<svg");
  const auto end = svg.find('>', tag);
  svg.insert(end + 1, "\n" + description.str());
}
} // namespace

struct VectorCanvas::Cairo
{
  PictureFormat format = PictureFormat::Pdf;
  double height = 0.0;
  std::string bytes;
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;
  CairoFonts fonts;

  explicit Cairo(const FontChoice& font)
    : fonts(font)
  {
  }

  void SetColor(const Rgba& color) const
  {
    cairo_set_source_rgba(
      context, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, color[3] / 255.0);
  }
};

VectorCanvas::VectorCanvas(PictureFormat format, int width, int height, double dpi,
  const Rgba& background, int fontSize, const FontChoice& font)
  : With(std::make_unique<Cairo>(font))
{
  const double point = kPointsPerInch / dpi;
  With->format = format;
  With->height = height;
  const auto create = format == PictureFormat::Pdf ? &cairo_pdf_surface_create_for_stream
                                                   : &cairo_svg_surface_create_for_stream;
  With->surface = create(&Append, &With->bytes, width * point, height * point);
  if (format != PictureFormat::Pdf)
  {
    // Without a unit, cairo 1.18 leaves the size to the viewer.
    cairo_svg_surface_set_document_unit(With->surface, CAIRO_SVG_UNIT_PT);
  }
  With->context = cairo_create(With->surface);
  cairo_scale(With->context, point, point);
  With->fonts.Set(With->context, {});
  cairo_set_font_size(With->context, fontSize);
  if (background[3] > 0)
  {
    With->SetColor(background);
    cairo_paint(With->context);
  }
  if (cairo_status(With->context) != CAIRO_STATUS_SUCCESS)
  {
    throw Error(std::string("cairo: ") + cairo_status_to_string(cairo_status(With->context)));
  }
}

VectorCanvas::~VectorCanvas()
{
  cairo_destroy(With->context);
  cairo_surface_destroy(With->surface);
}

void VectorCanvas::Place(const Image& picture)
{
  // Cairo needs premultiplied alpha, native byte order, and rows from the top.
  const int stride = cairo_format_stride_for_width(CAIRO_FORMAT_ARGB32, picture.width);
  std::vector<unsigned char> pixels(
    static_cast<std::size_t>(stride) * static_cast<std::size_t>(picture.height));
  const std::uint8_t* from = picture.pixels.data();
  for (int j = picture.height; j-- > 0;)
  {
    auto* row = reinterpret_cast<std::uint32_t*>(
      &pixels[static_cast<std::size_t>(stride) * static_cast<std::size_t>(j)]);
    for (int i = 0; i < picture.width; ++i, from += picture.channels)
    {
      const std::uint32_t alpha = picture.channels == 4 ? from[3] : 255U;
      const auto part = [&](int c) { return (from[c] * alpha + 127U) / 255U; };
      row[i] = alpha << 24U | part(0) << 16U | part(1) << 8U | part(2);
    }
  }
  cairo_surface_t* image = cairo_image_surface_create_for_data(
    pixels.data(), CAIRO_FORMAT_ARGB32, picture.width, picture.height, stride);
  cairo_set_source_surface(With->context, image, 0.0, With->height - picture.height);
  // Keeps pixels as sharp squares.
  cairo_pattern_set_filter(cairo_get_source(With->context), CAIRO_FILTER_NEAREST);
  cairo_paint(With->context);
  // Flushes now, because the pixels are freed after this block.
  cairo_surface_flush(With->surface);
  cairo_set_source_rgb(With->context, 0.0, 0.0, 0.0);
  cairo_surface_finish(image);
  cairo_surface_destroy(image);
}

void VectorCanvas::Fill(int x, int y, int width, int height, const Rgba& color)
{
  With->SetColor(color);
  cairo_rectangle(With->context, x, With->height - y - height, width, height);
  // Without anti-aliasing no background shows between the rows of a bar.
  cairo_set_antialias(With->context, CAIRO_ANTIALIAS_NONE);
  cairo_fill(With->context);
  cairo_set_antialias(With->context, CAIRO_ANTIALIAS_DEFAULT);
}

void VectorCanvas::Line(std::span<const CanvasPoint> points, double width, const Rgba& color)
{
  if (points.empty())
  {
    return;
  }
  With->SetColor(color);
  cairo_set_line_width(With->context, width);
  cairo_set_line_cap(With->context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(With->context, CAIRO_LINE_JOIN_ROUND);
  // Starts a new path instead of continuing after the last text.
  cairo_new_path(With->context);
  for (const CanvasPoint& point : points)
  {
    cairo_line_to(With->context, point[0], With->height - point[1]);
  }
  if (points.size() > 2 && points.front() == points.back())
  {
    cairo_close_path(With->context);
  }
  cairo_stroke(With->context);
}

double VectorCanvas::WidthOf(const std::string& text)
{
  return With->fonts.WidthOf(With->context, ValidUtf8(text));
}

void VectorCanvas::Write(
  const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color)
{
  const double width = WidthOf(text);
  const double left = anchor == TextAnchor::Left ? x
    : anchor == TextAnchor::Right                ? x - width
                                                 : x - 0.5 * width;
  With->SetColor(color);
  With->fonts.Write(With->context, ValidUtf8(text), left, With->height - y);
}

void VectorCanvas::WriteTurned(
  const std::string& text, const CanvasPoint& at, double angle, int fontSize, const Rgba& color)
{
  cairo_save(With->context);
  cairo_translate(With->context, at[0], With->height - at[1]);
  cairo_rotate(With->context, -angle * std::numbers::pi / 180.0);
  cairo_set_font_size(With->context, fontSize);
  const std::string valid = ValidUtf8(text);
  const double width = With->fonts.WidthOf(With->context, valid);
  With->SetColor(color);
  With->fonts.Write(With->context, valid, -0.5 * width, 0.0);
  cairo_restore(With->context);
}

void VectorCanvas::Clip(int width, int height)
{
  cairo_save(With->context);
  cairo_rectangle(With->context, 0.0, With->height - height, width, height);
  cairo_clip(With->context);
}

void VectorCanvas::Unclip()
{
  cairo_restore(With->context);
}

std::string VectorCanvas::Finish(const PictureTexts& texts, const std::string& file)
{
  const std::string description = ValidUtf8(LinesOf(texts));
  if (With->format == PictureFormat::Pdf)
  {
    cairo_pdf_surface_set_metadata(With->surface, CAIRO_PDF_METADATA_CREATOR, kPictureMark);
    cairo_pdf_surface_set_metadata(With->surface, CAIRO_PDF_METADATA_SUBJECT, description.c_str());
  }
  cairo_show_page(With->context);
  cairo_surface_finish(With->surface);
  const cairo_status_t status = cairo_surface_status(With->surface);
  if (status != CAIRO_STATUS_SUCCESS)
  {
    throw Error("cannot write '" + file + "': cairo: " + cairo_status_to_string(status));
  }
  if (With->format == PictureFormat::Svg)
  {
    AddDescription(
      "Software: " + std::string(kPictureMark) + (description.empty() ? "" : "\n" + description),
      With->bytes);
  }
  return std::move(With->bytes);
}
} // namespace pixelexact
