// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/Image.h"

#include "Views/TextImages.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
class RasterCanvas;

/// A number that a slider sets. Values are whole multiples of `step`, so that texts are exact.
struct SliderValue
{
  std::string option; ///< "--isosurface"
  std::string prefix; ///< of the option's value, "u="
  std::string name;   ///< shown over the slider
  double low = 0.0;
  double high = 1.0;
  double step = 1.0;
  double value = 0.0;

  /// The value as in the command line.
  [[nodiscard]] std::string Text() const;
};

/// A slider over at least the given range, with some hundred round values.
[[nodiscard]] SliderValue SliderOver(
  std::string option, std::string prefix, const std::array<double, 2>& range, double value);

/// The column beside the figure: the fields, the sliders and the text about the pixel under the
/// pointer. Positions are in pixels from the column's lower left corner.
class ViewPanel
{
public:
  /// Width in pixels beside a figure with letters of this height.
  [[nodiscard]] static int WidthBeside(int figureFont);

  std::vector<std::string> fields;
  std::optional<std::size_t> field; ///< the chosen one
  std::vector<SliderValue> sliders;
  std::string text;  ///< lines at the bottom; long ones are wrapped
  std::string title; ///< over the fields

  /// Draws the column, and remembers where its parts are.
  [[nodiscard]] Image Draw(int width, int height, const FontChoice& choice);

  /// The field at a position of the last drawing.
  [[nodiscard]] std::optional<std::size_t> FieldAt(double x, double y) const;
  [[nodiscard]] std::optional<std::size_t> SliderAt(double x, double y) const;
  /// The value of a slider whose knob is at `x`.
  [[nodiscard]] double ValueAt(std::size_t slider, double x) const;
  /// Shows fields further down in a list that does not fit.
  void Scroll(int by);

private:
  void DrawFields(RasterCanvas& canvas, double& y, double least);
  void DrawSlider(RasterCanvas& canvas, const SliderValue& slider, double y) const;
  /// Draws the text from below and returns its upper end.
  double DrawText(RasterCanvas& canvas) const;

  int Width = 0;
  int Font = 10;
  std::size_t First = 0;               ///< the uppermost visible field
  std::size_t Shown = 0;               ///< number of visible fields
  std::optional<std::size_t> Followed; ///< the field that the list was scrolled to
  double Top = 0.0;                    ///< upper end of the first visible field
  std::vector<double> Tracks;          ///< heights of the sliders' lines
};
} // namespace pixelexact
