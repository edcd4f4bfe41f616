// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <optional>
#include <string>

namespace pixelexact
{
class Canvas;
struct CameraView;

/// What a bar tells.
struct FigureBar
{
  std::string name;
  std::array<double, 2> range;
  const ColorMap* map;
};

/// What stands beside the picture of a figure, down a column. Heights are in pixels from below.
class FigureColumn
{
public:
  /// Of the font's size.
  static constexpr int kWidth = 11;

  FigureColumn(Canvas& canvas, int left, int font, const Rgba& ink);

  void DrawBar(
    const FigureBar& bar, int top, int height, bool logarithm, const std::optional<int>& bands);
  void Write(const std::string& text, double y);
  void DrawMark(const Rgba& color, const std::string& text, double y);
  /// The axes as the camera sees them.
  void DrawAxes(const CameraView& view, double y);
  /// `unit`: the world's in a pixel.
  void DrawScale(double unit, double y);

private:
  Canvas& To;
  int Left;
  int Font;
  Rgba Ink;
};
} // namespace pixelexact
