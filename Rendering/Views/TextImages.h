// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Modules/ColorMapping.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pixelexact
{
/// In pixels.
struct TextSize
{
  double width;
  double height;
};

/// Pixels, four bytes of straight alpha each, lower left first.
struct PixelSpan
{
  int width;
  int height;
  std::uint8_t* rgba;
};

/// Which of a text's points is put at a place; up and down it is the middle.
enum class TextAnchor
{
  Left,
  Centre,
  Right
};

/// Letters: VTK's own, without (Arial) or with serifs (Times), or those of a file.
struct FontChoice
{
  enum class Family
  {
    Sans,
    Serif,
    File
  };
  Family family = Family::Sans;
  std::string file; ///< TrueType, OpenType or Type 1
};

/// Texts of one font as pixels, by FreeType, without OpenGL.
class PIXELEXACTRENDERING_EXPORT TextImages
{
public:
  /// `size`: of the font, in pixels.
  explicit TextImages(int size, const FontChoice& font = {});
  ~TextImages();
  TextImages(const TextImages&) = delete;
  TextImages& operator=(const TextImages&) = delete;

  /// Unturned. Throws Error where FreeType makes no text.
  [[nodiscard]] TextSize SizeOf(const std::string& text);

  /// Puts a text over an image, as far as it is on it. `angle`: in degrees, against the clock.
  /// Throws Error where FreeType makes no text.
  void Put(const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color,
    double angle, const PixelSpan& to);

private:
  struct Font;
  std::unique_ptr<Font> With;
};
} // namespace pixelexact
