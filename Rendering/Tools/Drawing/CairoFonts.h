// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Views/TextImages.h"

#include <cairo.h>

#include <map>
#include <string>

namespace pixelexact
{
[[nodiscard]] bool IsAscii(const std::string& text);

/// A text as UTF-8; bytes that are none, which names of files and arrays may hold, become U+FFFD.
std::string ValidUtf8(const std::string& text);

/// The font that a text is written in: the one that was asked for, or, where that is one by name
/// and the text has letters beyond ASCII, the nearest file with these that fontconfig knows. Warns
/// once of a text with letters that the font lacks.
FontChoice FontWithLetters(const std::string& text, const FontChoice& asked);

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
