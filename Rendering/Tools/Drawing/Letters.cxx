// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Letters.h"

#include "Base/Report.h"

#include <fontconfig/fontconfig.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <set>

namespace pixelexact
{
namespace
{
using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Letters = std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)>;

/// Of valid UTF-8.
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
  static std::set<std::string> told;
  if (!told.insert(text).second)
  {
    return;
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
} // namespace pixelexact
