// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"
#include "Drawing/ImageFile.h"

#include <memory>
#include <string>

namespace pixelexact
{
/// A canvas of a PDF or SVG: pictures are embedded, pixel by pixel and without loss, lines and
/// letters stay what they are. Letters of a PDF are a subset of the font, with their texts; of an
/// SVG outlines.
class VectorCanvas final : public Canvas
{
public:
  /// Sizes are in pixels, `dpi` of them to an inch. Throws Error as Canvas.
  VectorCanvas(PictureFormat format, int width, int height, double dpi, const Rgba& background,
    int fontSize, const FontChoice& font);

  ~VectorCanvas() override;

  void Place(const Image& picture) override;

  /// The file's bytes; nothing can be drawn afterwards. `file`: for messages. Throws Error.
  std::string Finish(const PictureTexts& texts, const std::string& file);

private:
  VectorCanvas(std::unique_ptr<std::string> bytes, PictureFormat format, int width, int height,
    double point, int fontSize, const FontChoice& font);

  PictureFormat Format;
  std::unique_ptr<std::string> Bytes; ///< cairo has its address
};
} // namespace pixelexact
