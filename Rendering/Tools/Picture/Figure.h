// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Options.h"
#include "Picture/FigureLegend.h"
#include "Scene/Shot.h"

#include "Trace/Modules/ColorMapping.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pixelexact
{
class Canvas;
class ColorOptions;
class ShotAppearance;
struct Frame;

/// The contents of a figure.
struct FigureContent
{
  const Shot& shot; ///< with a layout
  const ShotAppearance& appearance;
  const Frame& frame;
  const ColorOptions& colors;
  bool hasBars = true;              ///< whether the colours of fields are visible
  std::vector<ColorMark> marks;     ///< in addition to those of unknown pixels and NaN
  std::optional<FigureBar> bar;     ///< in place of those of fields
  std::optional<FigureArrow> arrow; ///< of the picture's arrows
};

/// A picture with its legend: colour bars with ticks and the fields' names, a title, the time,
/// coordinates or the axes' directions, a scale where the picture has a uniform one, and the
/// colours of pixels without a value.
class FigureOptions
{
public:
  void AddTo(CLI::App& command);

  [[nodiscard]] bool IsAsked() const { return Asked; }
  /// Requests a figure without the option --figure.
  void Ask() { Asked = true; }
  /// The height of letters in pixels.
  [[nodiscard]] int FontOf(const ImageSize& figure) const;
  /// Throws UsageError where a figure of this size has no room for a picture.
  void Check(const ImageSize& size) const;
  /// The rectangles of a figure around a scene whose view has its final direction. `turns`: the
  /// view turns, so that coordinates do not stay along the picture's sides. They are left out where
  /// they have no room. Must be called after Check.
  [[nodiscard]] FigureLayout LayOut(const ImageSize& size, const Shot& shot, bool turns) const;

  /// Reports options without effect on a figure of this layout.
  void NoteEffects(const FigureLayout& layout, const Shot& shot) const;

  /// Draws the legend on a canvas of the figure's size that already contains the picture. Where the
  /// layout has coordinates and the view, while it is moved, has none, the axes' directions are
  /// drawn instead.
  void Draw(Canvas& canvas, const FigureContent& content) const;

private:
  enum class Axes
  {
    Coordinates,
    Directions,
    None
  };

  [[nodiscard]] std::vector<FigureBar> BarsOf(const FigureContent& content) const;
  void DrawLegend(FigureLegend& legend, const FigureContent& content, bool hasCoordinates) const;
  /// Reports values of --bar-ticks that are on no bar.
  void WarnOfTicks(const std::vector<FigureBar>& bars) const;

  bool Asked = false;
  std::string Title;
  std::string BarTitle;
  std::string Unit;
  std::string LengthUnit;
  std::optional<Axes> Which; ///< none: coordinates where the view has them
  std::optional<int> TickCount;
  std::vector<double> TickValues;
  std::optional<double> FontSize;
  bool InPoints = false;
};

/// The member "figure" of a report: "width" and "height"; "picture", the picture's lower left
/// corner; "font"; "legend", right or below; "coordinates", whether they are drawn.
nlohmann::ordered_json ToJson(const FigureLayout& layout);
} // namespace pixelexact
