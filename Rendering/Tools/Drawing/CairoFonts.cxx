// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CairoFonts.h"

#include "Base/Report.h"
#include "Core/Base/Error.h"

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

namespace pixelexact
{
namespace
{
using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Letters = std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)>;

/// The letters of a text, which must be valid UTF-8.
Letters LettersOf(const std::string& text)
{
  Letters letters(FcCharSetCreate(), &FcCharSetDestroy);
  const auto* at = reinterpret_cast<const FcChar8*>(text.data());
  int left = static_cast<int>(text.size());
  while (left > 0)
  {
    FcChar32 letter = 0;
    const int bytes = FcUtf8ToUcs4(at, &letter, left);
    if (bytes <= 0)
    {
      break;
    }
    FcCharSetAddChar(letters.get(), letter);
    at += bytes;
    left -= bytes;
  }
  return letters;
}

bool HasLetters(FcPattern* font, const Letters& letters)
{
  FcCharSet* own = nullptr;
  return font != nullptr && FcPatternGetCharSet(font, FC_CHARSET, 0, &own) == FcResultMatch &&
    FcCharSetIsSubset(letters.get(), own) == FcTrue;
}

void WarnOfMissing(const std::string& text)
{
  static std::mutex mutex;
  static std::set<std::string> warned;
  {
    const std::lock_guard lock(mutex);
    if (!warned.insert(text).second)
    {
      return;
    }
  }
  Warn(
    "'" + text + "' has letters that no font at hand holds; name one that does with --font FILE");
}
} // namespace

bool IsAscii(const std::string& text)
{
  return std::ranges::all_of(text, [](unsigned char c) { return c < 0x80U; });
}

std::string ValidUtf8(const std::string& text)
{
  const std::string quoted =
    nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return nlohmann::json::parse(quoted).get<std::string>();
}

FontChoice FontWithLetters(const std::string& text, const FontChoice& asked)
{
  if (IsAscii(text))
  {
    return asked;
  }
  const Letters letters = LettersOf(text);
  if (asked.family == FontChoice::Family::File)
  {
    int faces = 0;
    const Pattern file(
      FcFreeTypeQuery(reinterpret_cast<const FcChar8*>(asked.file.c_str()), 0, nullptr, &faces),
      &FcPatternDestroy);
    if (!HasLetters(file.get(), letters))
    {
      WarnOfMissing(text);
    }
    return asked;
  }
  const Pattern wanted(FcPatternCreate(), &FcPatternDestroy);
  const char* family = asked.family == FontChoice::Family::Serif ? "Times New Roman" : "Arial";
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
  FcPatternAddCharSet(wanted.get(), FC_CHARSET, letters.get());
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(nullptr, wanted.get(), &result), &FcPatternDestroy);
  FcChar8* file = nullptr;
  if (!HasLetters(found.get(), letters) ||
    FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch)
  {
    WarnOfMissing(text);
    return asked;
  }
  return { FontChoice::Family::File, reinterpret_cast<const char*>(file) };
}

namespace
{
/// The library is never freed, because cairo's cache of fonts is not freed.
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

/// FreeType creates and frees the faces of a library on one thread at a time.
std::mutex& FacesMutex()
{
  static std::mutex mutex;
  return mutex;
}

FT_Face OpenFace(const std::string& file)
{
  FT_Face face = nullptr;
  FT_Library library = Library();
  const std::lock_guard lock(FacesMutex());
  return FT_New_Face(library, file.c_str(), 0, &face) == 0 ? face : nullptr;
}

void CloseFace(void* face)
{
  const std::lock_guard lock(FacesMutex());
  FT_Done_Face(static_cast<FT_Face>(face));
}

cairo_font_face_t* MakeFace(const FontChoice& font)
{
  if (font.family != FontChoice::Family::File)
  {
    return cairo_toy_font_face_create(
      font.family == FontChoice::Family::Serif ? "Times New Roman" : "Arial",
      CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }
  FT_Face face = OpenFace(font.file);
  if (face == nullptr)
  {
    throw Error("--font: '" + font.file + "' cannot be read");
  }
  cairo_font_face_t* made = cairo_ft_font_face_create_for_ft_face(face, 0);
  // cairo caches font faces, so FreeType's face is freed with the cache entry.
  static const cairo_user_data_key_t kKey{};
  cairo_font_face_set_user_data(made, &kKey, face, &CloseFace);
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
  // All texts of a column share one base line.
  cairo_text_extents_t digit;
  cairo_text_extents(context, "0", &digit);
  cairo_move_to(context, left, y + 0.5 * digit.height);
  cairo_show_text(context, text.c_str());
}
} // namespace pixelexact
