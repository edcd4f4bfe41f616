// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PixelExactRenderingModule.h"
#include "Trace/Modules/ColorMapping.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pixelexact
{
/// Black or white, whichever is readable on a colour.
[[nodiscard]] PIXELEXACTRENDERING_EXPORT Rgba InkOn(const Rgba& background);

/// Size of a text, in pixels.
struct TextSize
{
  double width;
  double height;
};

/// Pixels of four bytes with straight alpha, lower left first.
struct PixelSpan
{
  int width;
  int height;
  std::uint8_t* rgba;
};

/// The point of a text that is put at a place; vertically, it is the middle.
enum class TextAnchor
{
  Left,
  Centre,
  Right
};

/// A font: VTK's own without serifs (Arial) or with serifs (Times), or that of a file.
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

/// Renders texts of one font to pixels, by FreeType, without OpenGL.
class PIXELEXACTRENDERING_EXPORT TextImages
{
public:
  /// `size`: of the font, in pixels.
  explicit TextImages(int size, const FontChoice& font = {});
  ~TextImages();
  TextImages(const TextImages&) = delete;
  TextImages& operator=(const TextImages&) = delete;

  /// Size of a text before rotation. Throws Error if FreeType fails.
  [[nodiscard]] TextSize SizeOf(const std::string& text);

  /// Draws a text over an image; parts outside the image are clipped. `angle`: in degrees,
  /// anticlockwise. `halo`: the colour of a rim around the letters, an eighth of the font's size
  /// wide; alpha 0: none. Throws Error if FreeType fails.
  void Put(const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color,
    double angle, const PixelSpan& to, const Rgba& halo = {});

private:
  struct Font;
  std::unique_ptr<Font> With;
};
} // namespace pixelexact
