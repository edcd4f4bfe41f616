// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"
#include "Drawing/ImageFile.h"

#include <memory>
#include <string>

namespace pixelexact
{
/// A canvas of a PDF or SVG, by cairo: pictures are embedded, pixel by pixel and without loss,
/// lines and letters stay what they are. Letters of a PDF are a subset of the font, with their
/// texts; of an SVG outlines. Fonts: what fontconfig has for Arial and Times New Roman, or a file.
class VectorCanvas final : public Canvas
{
public:
  /// Sizes are in pixels, `dpi` of them to an inch. Throws Error where cairo has no memory or no
  /// font.
  VectorCanvas(PictureFormat format, int width, int height, double dpi, const Rgba& background,
    int fontSize, const FontChoice& font);
  ~VectorCanvas() override;

  using Canvas::Line;
  void Place(const Image& picture) override;
  void Fill(int x, int y, int width, int height, const Rgba& color) override;
  void Line(std::span<const CanvasPoint> points, double width, const Rgba& color) override;
  void Write(
    const std::string& text, double x, double y, TextAnchor anchor, const Rgba& color) override;
  [[nodiscard]] double WidthOf(const std::string& text) override;

  /// A text of a size of its own about its middle, anticlockwise by an angle in degrees.
  void WriteTurned(
    const std::string& text, const CanvasPoint& at, double angle, int fontSize, const Rgba& color);

  /// Draws within a part of it alone, from the lower left corner, until Unclip.
  void Clip(int width, int height);
  void Unclip();

  /// The file's bytes; nothing can be drawn afterwards. `file`: for messages. Throws Error.
  std::string Finish(const PictureTexts& texts, const std::string& file);

private:
  struct Cairo;
  std::unique_ptr<Cairo> With;
};
} // namespace pixelexact
