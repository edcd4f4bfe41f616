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

/// The data of a colour bar.
struct FigureBar
{
  std::string name;
  std::array<double, 2> range;
  const ColorMap* map;
};

/// The column beside the picture of a figure. Heights are in pixels from below.
class FigureColumn
{
public:
  /// Width of the column in units of the font's size.
  static constexpr int kWidth = 11;

  FigureColumn(Canvas& canvas, int left, int font, const Rgba& ink);

  void DrawBar(
    const FigureBar& bar, int top, int height, bool logarithm, const std::optional<int>& bands);
  void Write(const std::string& text, double y);
  void DrawMark(const Rgba& color, const std::string& text, double y);
  /// Draws the axes in the camera's orientation.
  void DrawAxes(const CameraView& view, double y);
  /// `unit`: length of a pixel in world units.
  void DrawScale(double unit, double y);

private:
  Canvas& To;
  int Left;
  int Font;
  Rgba Ink;
};
} // namespace pixelexact
