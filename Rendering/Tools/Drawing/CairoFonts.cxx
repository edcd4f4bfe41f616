// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CairoFonts.h"

#include "Base/Report.h"
#include "Core/Base/Error.h"

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
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

/// The letters of a text that are not ASCII.
std::string BeyondAscii(const std::string& text)
{
  std::string letters;
  std::ranges::copy_if(
    text, std::back_inserter(letters), [](unsigned char c) { return c >= 0x80U; });
  return letters;
}

bool HasLetters(FcPattern* font, const Letters& letters)
{
  FcCharSet* own = nullptr;
  return font != nullptr && FcPatternGetCharSet(font, FC_CHARSET, 0, &own) == FcResultMatch &&
    FcCharSetIsSubset(letters.get(), own) == FcTrue;
}

void WarnOfMissing(const std::string& letters)
{
  static std::mutex mutex;
  static std::set<std::string> warned;
  {
    const std::lock_guard lock(mutex);
    if (letters.empty() || !warned.insert(letters).second)
    {
      return;
    }
  }
  Warn("no font at hand holds all of the letters '" + letters +
    "'; name one that does with --font FILE");
}

/// The font file with letters beyond ASCII and the minus sign of print; `asked` where that is a
/// file, or where no font has them.
FontChoice FontWithLetters(const std::string& letters, const FontChoice& asked)
{
  if (asked.family == FontChoice::Family::File)
  {
    int faces = 0;
    const Pattern file(
      FcFreeTypeQuery(reinterpret_cast<const FcChar8*>(asked.file.c_str()), 0, nullptr, &faces),
      &FcPatternDestroy);
    if (!HasLetters(file.get(), LettersOf(letters)))
    {
      WarnOfMissing(letters);
    }
    return asked;
  }
  const Letters all = LettersOf(letters + "\u2212");
  const Pattern wanted(FcPatternCreate(), &FcPatternDestroy);
  const char* family = asked.family == FontChoice::Family::Serif ? "Times New Roman" : "Arial";
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
  FcPatternAddCharSet(wanted.get(), FC_CHARSET, all.get());
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(nullptr, wanted.get(), &result), &FcPatternDestroy);
  FcChar8* file = nullptr;
  if (!HasLetters(found.get(), LettersOf(letters)) ||
    FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch)
  {
    WarnOfMissing(letters);
    return asked;
  }
  return { FontChoice::Family::File, reinterpret_cast<const char*>(file) };
}

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

std::string ValidUtf8(const std::string& text)
{
  const std::string quoted =
    nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return nlohmann::json::parse(quoted).get<std::string>();
}

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
  const auto [chosen, isNew] = Chosen.try_emplace(BeyondAscii(text));
  if (isNew)
  {
    chosen->second = FontWithLetters(chosen->first, Asked);
  }
  const FontChoice& font = chosen->second;
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

void CairoFonts::MoveTo(cairo_t* context, const std::string& text, double left, double y)
{
  Set(context, text);
  // All texts of a column share one base line.
  cairo_text_extents_t digit;
  cairo_text_extents(context, "0", &digit);
  cairo_move_to(context, left, y + 0.5 * digit.height);
}

void CairoFonts::Write(cairo_t* context, const std::string& text, double left, double y)
{
  MoveTo(context, text, left, y);
  cairo_show_text(context, text.c_str());
}

void CairoFonts::AddOutline(cairo_t* context, const std::string& text, double left, double y)
{
  MoveTo(context, text, left, y);
  cairo_text_path(context, text.c_str());
}
} // namespace pixelexact
