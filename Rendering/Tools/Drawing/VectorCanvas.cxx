// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/VectorCanvas.h"

#include "Base/ImageSize.h"
#include "Base/Provenance.h"
#include "Drawing/CairoFonts.h"
#include "Drawing/Picture.h"

#include "Core/Base/Error.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <sstream>

namespace pixelexact
{
namespace
{
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

/// Numbers the names of an SVG's parts, "image5", by their order in it. Cairo counts all surfaces
/// of the process.
std::string WithNumberedNames(const std::string& svg)
{
  std::map<std::string, std::size_t> numbers;
  std::string result;
  result.reserve(svg.size());
  std::size_t at = 0;
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  while (at < svg.size())
  {
    // Pictures are base64, which has neither.
    std::size_t begin = std::min(svg.find('#', at), svg.find(" id=\"", at));
    if (begin == std::string::npos)
    {
      break;
    }
    begin += svg[begin] == '#' ? 1 : 5;
    const std::size_t digits = svg.find_first_of("0123456789\")", begin);
    const std::size_t end = svg.find_first_of("\")", begin);
    result.append(svg, at, begin - at);
    at = begin;
    if (end != std::string::npos && digits < end &&
      std::all_of(svg.begin() + static_cast<std::ptrdiff_t>(digits),
        svg.begin() + static_cast<std::ptrdiff_t>(end), isDigit))
    {
      const std::size_t number =
        numbers.try_emplace(svg.substr(begin, end - begin), numbers.size()).first->second;
      result.append(svg, begin, digits - begin).append(std::to_string(number));
      at = end;
    }
  }
  return result.append(svg, at, std::string::npos);
}

cairo_surface_t* CreateSurface(
  PictureFormat format, std::string& bytes, double width, double height)
{
  if (format == PictureFormat::Pdf)
  {
    return cairo_pdf_surface_create_for_stream(&Append, &bytes, width, height);
  }
  cairo_surface_t* surface = cairo_svg_surface_create_for_stream(&Append, &bytes, width, height);
  // Without a unit, cairo 1.18 leaves the size to the viewer.
  cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PT);
  return surface;
}
} // namespace

VectorCanvas::VectorCanvas(PictureFormat format, int width, int height, double dpi,
  const Rgba& background, int fontSize, const FontChoice& font)
  : VectorCanvas(
      std::make_unique<std::string>(), format, width, height, kPointsPerInch / dpi, fontSize, font)
{
  if (background[3] > 0)
  {
    cairo_set_source_rgb(
      Context, background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
    cairo_paint(Context);
  }
}

VectorCanvas::VectorCanvas(std::unique_ptr<std::string> bytes, PictureFormat format, int width,
  int height, double point, int fontSize, const FontChoice& font)
  : Canvas(CreateSurface(format, *bytes, width * point, height * point), width, height, point,
      fontSize, font)
  , Format(format)
  , Bytes(std::move(bytes))
{
}

VectorCanvas::~VectorCanvas()
{
  // Writes into Bytes, which are freed before the surface.
  cairo_surface_finish(Surface);
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
  cairo_set_source_surface(Context, image, 0.0, Height - picture.height);
  // Keeps pixels as sharp squares.
  cairo_pattern_set_filter(cairo_get_source(Context), CAIRO_FILTER_NEAREST);
  cairo_paint(Context);
  // Flushes now, because the pixels are freed after this block.
  cairo_surface_flush(Surface);
  cairo_set_source_rgb(Context, 0.0, 0.0, 0.0);
  cairo_surface_finish(image);
  cairo_surface_destroy(image);
}

std::string VectorCanvas::Finish(const PictureTexts& texts, const std::string& file)
{
  const std::string description = ValidUtf8(LinesOf(texts));
  if (Format == PictureFormat::Pdf)
  {
    cairo_pdf_surface_set_metadata(Surface, CAIRO_PDF_METADATA_CREATOR, kPictureMark);
    cairo_pdf_surface_set_metadata(Surface, CAIRO_PDF_METADATA_SUBJECT, description.c_str());
  }
  cairo_show_page(Context);
  cairo_surface_finish(Surface);
  const cairo_status_t status = cairo_surface_status(Surface);
  if (status != CAIRO_STATUS_SUCCESS)
  {
    throw Error("cannot write '" + file + "': cairo: " + cairo_status_to_string(status));
  }
  if (Format == PictureFormat::Svg)
  {
    *Bytes = WithNumberedNames(*Bytes);
    AddDescription(
      "Software: " + std::string(kPictureMark) + (description.empty() ? "" : "\n" + description),
      *Bytes);
  }
  return std::move(*Bytes);
}
} // namespace pixelexact
