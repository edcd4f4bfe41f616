// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/FontOptions.h"

#include "Core/Base/Error.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <filesystem>

namespace pixelexact
{
void FontOptions::AddTo(CLI::App& command)
{
  Bind(command, "--font",
    [this](const std::string& text)
    {
      const bool named = text == "sans" || text == "serif";
      Font.family = text == "serif" ? FontChoice::Family::Serif
        : named                     ? FontChoice::Family::Sans
                                    : FontChoice::Family::File;
      Font.file = named ? std::string() : text;
    });
}

void FontOptions::Check() const
{
  if (Font.family != FontChoice::Family::File)
  {
    return;
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(Font.file, ignored))
  {
    throw Error("--font: there is no file '" + Font.file + "'; name one, or sans or serif");
  }
  // Checks with FreeType itself, because VTK replaces an unreadable file by another font without a
  // message.
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  const bool readable = FT_Init_FreeType(&library) == 0 &&
    FT_New_Face(library, Font.file.c_str(), 0, &face) == 0 && FT_IS_SCALABLE(face);
  FT_Done_Face(face);
  FT_Done_FreeType(library);
  if (!readable)
  {
    throw Error("--font: '" + Font.file +
      "' is no font that can be read; name a TrueType, OpenType or Type 1 file, or sans or serif");
  }
}
} // namespace pixelexact
