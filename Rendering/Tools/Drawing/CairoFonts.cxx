// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CairoFonts.h"

#include "Core/Base/Error.h"

#include <cairo-ft.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <utility>

namespace pixelexact
{
namespace
{
/// Never freed, as cairo's cache of fonts is not.
FT_Library Library()
{
  static const FT_Library kLibrary = []
  {
    FT_Library library = nullptr;
    FT_Init_FreeType(&library);
    return library;
  }();
  return kLibrary;
}

cairo_font_face_t* MakeFace(const FontChoice& font)
{
  if (font.family != FontChoice::Family::File)
  {
    return cairo_toy_font_face_create(
      font.family == FontChoice::Family::Serif ? "Times New Roman" : "Arial",
      CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }
  FT_Face face = nullptr;
  if (FT_New_Face(Library(), font.file.c_str(), 0, &face) != 0)
  {
    throw Error("--font: '" + font.file + "' cannot be read");
  }
  cairo_font_face_t* made = cairo_ft_font_face_create_for_ft_face(face, 0);
  // cairo keeps fonts in a cache of its own: the face ends with what is there.
  static const cairo_user_data_key_t kKey{};
  cairo_font_face_set_user_data(
    made, &kKey, face, [](void* of) { FT_Done_Face(static_cast<FT_Face>(of)); });
  return made;
}
} // namespace

CairoFonts::CairoFonts(FontChoice asked)
  : Asked(std::move(asked))
{
}

CairoFonts::~CairoFonts()
{
  for (const auto& [file, face] : Faces)
  {
    cairo_font_face_destroy(face);
  }
}

void CairoFonts::Set(cairo_t* context, const std::string& text)
{
  const FontChoice font = FontWithLetters(text, Asked);
  cairo_font_face_t*& face = Faces[font.file];
  if (face == nullptr)
  {
    face = MakeFace(font);
  }
  cairo_set_font_face(context, face);
}

double CairoFonts::WidthOf(cairo_t* context, const std::string& text)
{
  Set(context, text);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

void CairoFonts::Write(cairo_t* context, const std::string& text, double left, double y)
{
  Set(context, text);
  // All texts of a column have one line.
  cairo_text_extents_t digit;
  cairo_text_extents(context, "0", &digit);
  cairo_move_to(context, left, y + 0.5 * digit.height);
  cairo_show_text(context, text.c_str());
}
} // namespace pixelexact
