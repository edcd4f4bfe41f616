// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Canvas.h"
#include "Drawing/Ticks.h"

#include "Trace/Modules/ColorMapping.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
struct CameraView;
struct FigureLayout;

/// A colour that does not stand for a value, and its meaning.
struct ColorMark
{
  Rgba color;
  std::string text;
};

/// The data of a colour bar.
struct FigureBar
{
  std::string name;
  std::array<double, 2> range;
  ColorMap map;
  bool logarithm = false;
  std::array<bool, 2> beyond{};      ///< values lie below the range, above it: the ends get arrows
  std::optional<int> bands = {};     ///< the ticks are at their ends
  std::vector<double> ticks = {};    ///< values; empty: round ones and the ends of the range
  std::optional<int> tickCount = {}; ///< largest number of round values; none: as there is room
};

/// An arrow of a round length, to read the lengths of the picture's arrows by.
struct FigureArrow
{
  double longest;        ///< of the vectors
  double pixelsPerValue; ///< length of an arrow, for a vector of length 1
  std::string field;
  std::function<void(const CanvasPoint& from, const CanvasPoint& to)> draw;
};

/// The legend of a figure: a column on the right of its picture, or a strip below it. Each call
/// adds what it draws; the bars, which come last, fill the rest.
class FigureLegend
{
public:
  /// Width of the column and height of the strip, in units of the font's size.
  static constexpr int kColumn = 10;
  static constexpr int kStrip = 7;

  FigureLegend(Canvas& canvas, const FigureLayout& layout, const Rgba& ink);

  /// Draws the axes in the camera's orientation.
  void AddDirections(const CameraView& view);
  /// `unit`: length of a pixel in the world; `name`: the unit of lengths, or nothing.
  void AddScale(double unit, const std::string& name);
  void AddMark(const ColorMark& mark);
  void AddText(const std::string& text);
  void AddArrow(const FigureArrow& arrow);
  /// Warns of bars that have no room.
  void AddBars(const std::vector<FigureBar>& bars);

private:
  struct Box
  {
    int x;
    int y;
    int width;
    int height;
  };

  /// The left end of the next rows' middle, from which `rows` rows run downwards.
  [[nodiscard]] CanvasPoint NextRows(std::size_t rows);
  void Write(const std::string& text, const CanvasPoint& at, double room);
  [[nodiscard]] int MaxTicks(int length, bool isUpright) const;
  /// A bar in the strip, from `left`, and one in the column, down from `top`.
  void AddBarBelow(const FigureBar& bar, double left, double room);
  void AddBarBeside(const FigureBar& bar, double top, double room);
  /// `isUpright`: values grow upwards, else to the right.
  void DrawBar(const FigureBar& bar, Box box, bool isUpright);
  void DrawColors(const FigureBar& bar, const Box& box, bool isUpright);
  void DrawArrow(const FigureBar& bar, const Box& box, bool isUpright, bool isUpper);
  void DrawTicks(const FigureBar& bar, const Box& box, bool isUpright);

  Canvas& To;
  const FigureLayout& Layout;
  Rgba Ink;
  int Font;
  double Pen;
  /// Column: the height that is taken from below. Strip: what is left, from the left.
  double Taken = 0.0;
  std::size_t Rows = 0; ///< of the strip's last column of rows
};
} // namespace pixelexact
