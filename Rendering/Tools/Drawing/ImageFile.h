// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Provenance.h"
#include "Drawing/Image.h"

#include <optional>
#include <string>

namespace pixelexact
{
enum class PictureFormat
{
  Png,
  Tiff,
  Jpeg,
  Svg,
  Pdf
};

/// By the suffix of its name; standard output gets a PNG. Throws UsageError for another suffix.
PictureFormat FormatOf(const char* option, const std::string& file);
/// Whether lines and letters stay what they are.
bool IsVector(PictureFormat format);
/// Whether pixels may be transparent.
bool HasAlpha(PictureFormat format);

/// What a picture's file says of itself, beside the program that made it.
struct PictureFacts
{
  std::optional<double> dpi; ///< pixels in an inch; none: not told
  PictureTexts texts;
  int jpegQuality = 95; ///< 1 to 100
};

/// The bytes of a PNG, TIFF or JPEG. PNG and TIFF keep every pixel as it is; JPEG
/// does not, and has no alpha. `file`: for messages. Throws Error where it cannot be made.
std::string EncodeImage(
  const Image& image, PictureFormat format, const PictureFacts& facts, const std::string& file);
} // namespace pixelexact
