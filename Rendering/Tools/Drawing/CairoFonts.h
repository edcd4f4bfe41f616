// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Views/TextImages.h"

#include <cairo.h>

#include <map>
#include <string>

namespace pixelexact
{
/// A text as UTF-8. Bytes that are not UTF-8, which names of files and arrays may contain, become
/// U+FFFD.
std::string ValidUtf8(const std::string& text);

/// Cairo's fonts for texts: a file, or by family the nearest to Arial or Times New Roman that
/// fontconfig has with the letters of a text and the minus sign of print. Warns once about letters
/// beyond ASCII that no font has. Texts must be valid UTF-8.
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
  /// Adds the outlines of the letters of Write to the context's path.
  void AddOutline(cairo_t* context, const std::string& text, double left, double y);

private:
  /// Sets the font and the context's point where the text begins.
  void MoveTo(cairo_t* context, const std::string& text, double left, double y);

  FontChoice Asked;
  std::map<std::string, FontChoice> Chosen;        ///< by the letters beyond ASCII
  std::map<std::string, cairo_font_face_t*> Faces; ///< by file; "": the one of a name
};
} // namespace pixelexact
