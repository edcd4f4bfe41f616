// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Views/TextImages.h"

#include <cairo.h>

#include <map>
#include <string>

namespace pixelexact
{
[[nodiscard]] bool IsAscii(const std::string& text);

/// A text as UTF-8. Bytes that are not UTF-8, which names of files and arrays may contain, become
/// U+FFFD.
std::string ValidUtf8(const std::string& text);

/// The font of a text: `asked`, or, where that is given by family and the text has letters beyond
/// ASCII, the nearest font file of fontconfig with these letters. Warns once about a text with
/// letters that the font lacks.
FontChoice FontWithLetters(const std::string& text, const FontChoice& asked);

/// Cairo's fonts for texts: fontconfig's fonts for Arial and Times New Roman, or a file. For
/// letters that these lack see FontWithLetters. Texts must be valid UTF-8.
class CairoFonts
{
public:
  explicit CairoFonts(FontChoice asked);
  ~CairoFonts();
  CairoFonts(const CairoFonts&) = delete;
  CairoFonts& operator=(const CairoFonts&) = delete;

  /// Sets the font of a text. Throws Error where its file cannot be read.
  void Set(cairo_t* context, const std::string& text);
  /// Sets the font of a text and returns the text's width.
  [[nodiscard]] double WidthOf(cairo_t* context, const std::string& text);
  /// Writes a text from `left`. `y`, measured from above, is the middle of digits.
  void Write(cairo_t* context, const std::string& text, double left, double y);

private:
  FontChoice Asked;
  std::map<std::string, cairo_font_face_t*> Faces; ///< by file; "": the one of a name
};
} // namespace pixelexact
