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

/// The format by the suffix of the file's name; standard output gets a PNG. Throws UsageError for
/// another suffix.
PictureFormat FormatOf(const char* option, const std::string& file);
/// Whether the format keeps lines and letters as vectors.
bool IsVector(PictureFormat format);
/// Whether pixels may be transparent.
bool HasAlpha(PictureFormat format);

/// Metadata of a picture's file, in addition to the program's name.
struct PictureFacts
{
  std::optional<double> dpi; ///< pixels in an inch; none: not stored
  PictureTexts texts;
  int jpegQuality = 95; ///< 1 to 100
  int pngEffort = 5;    ///< zlib's level, 1 (fast) to 9 (small); the pixels are the same
};

/// The bytes of a PNG, TIFF or JPEG. PNG and TIFF are lossless; JPEG is not, and has no alpha.
/// `file`: for messages. Throws Error where encoding fails.
std::string EncodeImage(
  const Image& image, PictureFormat format, const PictureFacts& facts, const std::string& file);
} // namespace pixelexact
