// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Letters.h"

#include <cairo.h>

#include <map>
#include <string>

namespace pixelexact
{
/// Fonts of cairo for texts: what fontconfig has for Arial and Times New Roman, or a file; of
/// letters that these lack see FontWithLetters. Texts are valid UTF-8.
class CairoFonts
{
public:
  explicit CairoFonts(FontChoice asked);
  ~CairoFonts();
  CairoFonts(const CairoFonts&) = delete;
  CairoFonts& operator=(const CairoFonts&) = delete;

  /// Sets the font of a text. Throws Error where its file cannot be read.
  void Set(cairo_t* context, const std::string& text);
  /// Sets it, and tells the text's width.
  [[nodiscard]] double WidthOf(cairo_t* context, const std::string& text);
  /// Writes a text from the left; up and down `y`, from above, is the middle of digits.
  void Write(cairo_t* context, const std::string& text, double left, double y);

private:
  FontChoice Asked;
  std::map<std::string, cairo_font_face_t*> Faces; ///< by file; "": the one of a name
};
} // namespace pixelexact
