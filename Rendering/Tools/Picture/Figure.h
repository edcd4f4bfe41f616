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

/// A colour that does not stand for a value, and its meaning.
struct ColorMark
{
  Rgba color;
  std::string text;
};

/// The contents of a figure.
struct FigureContent
{
  const Shot& shot;
  const ShotAppearance& appearance;
  const Frame& frame;
  const ColorOptions& colors;
  bool bars = true;             ///< whether colours of maps are visible
  std::vector<ColorMark> marks; ///< in addition to those of unknown pixels and NaN
};

/// A text colour that contrasts with the background.
Rgba InkOn(const Rgba& background);

/// A picture with its legend: colour bars with ticks and the fields' names, a title, the time, the
/// axes, a scale where the picture has a uniform one, and the colours of pixels without a value.
class FigureOptions
{
public:
  void AddTo(CLI::App& command);

  [[nodiscard]] bool IsAsked() const { return Asked; }
  /// Requests a figure without the option --figure.
  void Ask() { Asked = true; }
  /// Throws UsageError where a figure of this size has no room for a picture.
  void Check(const ImageSize& size) const;
  /// The size of the picture in a figure. The margins on its left and above belong to the figure.
  [[nodiscard]] ImageSize PictureSize(const ImageSize& figure) const;

  /// The height of letters in pixels.
  [[nodiscard]] int FontOf(const ImageSize& figure) const;

  /// Draws the legend on a canvas of the figure's size that already contains the picture.
  void Draw(Canvas& canvas, const ImageSize& figure, const FigureContent& content) const;

private:
  bool Asked = false;
  std::string Title;
  std::optional<double> FontSize;
  bool InPoints = false;
};
} // namespace pixelexact
