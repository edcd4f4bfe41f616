// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"

#include "Trace/Modules/ColorMapping.h"

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
class Canvas;
class ColorOptions;
class ShotAppearance;
struct Frame;
struct Shot;

/// A colour that is no value's, and what it says.
struct ColorMark
{
  Rgba color;
  std::string text;
};

/// What a figure is of.
struct FigureContent
{
  const Shot& shot;
  const ShotAppearance& appearance;
  const Frame& frame;
  const ColorOptions& colors;
  bool bars = true;             ///< the map's colours are seen
  std::vector<ColorMark> marks; ///< beside those for unknown pixels and values that are no numbers
};

/// The ink that is read on a background.
Rgba InkOn(const Rgba& background);

/// A picture with what a reader needs: bars of the colours with ticks and the fields' names, a
/// title, the time, the axes, a scale where lengths in the picture have one, and what pixels show
/// no value.
class FigureOptions
{
public:
  void AddTo(CLI::App& command);

  [[nodiscard]] bool IsAsked() const { return Asked; }
  /// Also without --figure.
  void Ask() { Asked = true; }
  /// Throws UsageError where a figure of this size has no room for a picture.
  void Check(const ImageSize& size) const;
  /// Of the picture in a figure: what is left of it and above are margins.
  [[nodiscard]] ImageSize PictureSize(const ImageSize& figure) const;

  /// Of the letters, in pixels.
  [[nodiscard]] int FontOf(const ImageSize& figure) const;

  /// On a canvas of the figure's size, which has the picture: what is around it.
  void Draw(Canvas& canvas, const ImageSize& figure, const FigureContent& content) const;

private:
  bool Asked = false;
  std::string Title;
  std::optional<double> FontSize;
  bool InPoints = false;
};
} // namespace pixelexact
