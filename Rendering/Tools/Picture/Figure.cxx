// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/Figure.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Report.h"
#include "Drawing/Canvas.h"
#include "Picture/FigureAxes.h"
#include "Scene/ColorOptions.h"
#include "Scene/ContourOptions.h"
#include "Scene/LayerRanges.h"
#include "Scene/ShotAppearance.h"

#include <nlohmann/json.hpp>
#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kSmallestFont = 8.0;
constexpr double kLargestFont = 200.0;
constexpr double kDefaultPoints = 7.0;
constexpr double kSmallestPoints = 4.0;
/// Height of a title, in units of the font's size.
constexpr int kTitle = 3;
/// Smallest height of a figure with a column, in units of the font's size.
constexpr int kLowest = 18;
/// Smallest width of a figure with a strip.
constexpr int kNarrowest = 20;
/// Aspect above which a figure whose height is not given has its legend below the picture.
constexpr double kWide = 2.2;
/// Smallest side of a picture, in pixels.
constexpr int kMin = 32;

/// The name of a layer's values: "u", "|v|" for a magnitude, "v 0" for a component.
std::string NameOf(const Layer& layer)
{
  const std::string& name = layer.field->name;
  if (layer.field->values.components == 1)
  {
    return name;
  }
  return layer.component == kMagnitude ? "|" + name + "|" : name + " " + ComponentName(layer);
}

/// The unit of a layer's values that its file states; empty where it states none.
std::string UnitInFile(const Shot& shot, const Layer& layer)
{
  vtkAbstractArray* array =
    shot.input.grid->GetPointData()->GetAbstractArray(layer.field->name.c_str());
  if (array == nullptr || !array->HasInformation() ||
    array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()) == 0)
  {
    return {};
  }
  return array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
}

/// Divides a figure for a mesh whose box has an aspect in the picture.
FigureLayout Divide(
  const ImageSize& size, int font, bool hasTitle, double aspect, bool hasCoordinates)
{
  FigureLayout layout{ size, {}, {}, font, false, hasCoordinates };
  layout.corner = hasCoordinates ? std::array{ 6 * font, 4 * font } : std::array{ 0, 0 };
  const int top = hasTitle ? kTitle * font : hasCoordinates ? font : 0;
  const int beside = size.width - layout.corner[0] - FigureLegend::kColumn * font;
  const int below = size.width - layout.corner[0] - (hasCoordinates ? font : 0);
  const int strip = FigureLegend::kStrip * font;
  if (size.height == 0)
  {
    layout.legendBelow = aspect > kWide && size.width >= kNarrowest * font;
    const int width = layout.legendBelow ? below : beside;
    const int height = static_cast<int>(std::clamp(width / aspect, 0.1 * width, 1.6 * width));
    layout.size.height =
      std::max(height + layout.corner[1] + top + (layout.legendBelow ? strip : 0),
        layout.legendBelow ? 0 : kLowest * font);
    layout.size.height += layout.size.height % 2; // as videos need it
  }
  const int height = layout.size.height - layout.corner[1] - top;
  if (size.height > 0)
  {
    // The legend is where it leaves more room to the mesh.
    const auto scale = [aspect](int across, int up)
    { return std::min(across / aspect, static_cast<double>(up)); };
    layout.legendBelow =
      size.width >= kNarrowest * font && scale(below, height - strip) > 1.1 * scale(beside, height);
  }
  layout.picture = { layout.legendBelow ? below : beside,
    layout.legendBelow ? height - strip : height, {} };
  layout.corner[1] += layout.legendBelow ? strip : 0;
  return layout;
}

bool HasRoom(const FigureLayout& layout)
{
  return layout.picture.width >= kMin && layout.picture.height >= kMin &&
    (layout.legendBelow ? layout.size.width >= kNarrowest * layout.font
                        : layout.size.height >= kLowest * layout.font);
}

/// Texts of --axes, in the order of FigureOptions::Axes.
constexpr std::array kAxesWords{ "coordinates", "directions", "none" };
} // namespace

void FigureOptions::AddTo(CLI::App& command)
{
  Bind(command, "--figure", Asked);
  Bind(command, "--title", Title);
  Bind(command, "--bar-title", BarTitle);
  Bind(command, "--unit", Unit);
  Bind(command, "--length-unit", LengthUnit);
  Bind(command, "--axes",
    [this](const std::string& text)
    { Which = static_cast<Axes>(std::ranges::find(kAxesWords, text) - kAxesWords.begin()); });
  Bind(command, "--bar-ticks",
    [this](const std::string& text)
    {
      if (text.find_first_not_of("0123456789.,+-eE") != std::string::npos)
      {
        Refuse("--bar-ticks", text, "the largest number of ticks, or values with ',' between them");
      }
      const ContourRule ticks = ReadContours("--bar-ticks", text, ',');
      TickCount = ticks.count > 0 ? std::optional(ticks.count) : std::nullopt;
      TickValues = ticks.values;
    });
  Bind(command, "--font-size",
    [this](const std::string& text)
    {
      double size = 0.0;
      InPoints = text.ends_with("pt");
      const double least = InPoints ? kSmallestPoints : kSmallestFont;
      if (!ParseNumber(std::string_view(text).substr(0, text.size() - (InPoints ? 2 : 0)), size) ||
        !(size >= least && size <= kLargestFont))
      {
        Refuse("--font-size", text,
          fmt::format("pixels, a number from {} to {}, or points, 7pt", least, kLargestFont));
      }
      FontSize = size;
    });
}

int FigureOptions::FontOf(const ImageSize& figure) const
{
  // A point of print has a length in pixels where the figure has a size in inches.
  const double point = figure.inches ? figure.width / (*figure.inches)[0] / kPointsPerInch : 1.0;
  const double height = figure.height > 0 ? figure.height : 0.7 * figure.width;
  const double usual = figure.inches
    ? kDefaultPoints * point
    : std::clamp(std::min(height / 40.0, figure.width / 30.0), 10.0, kLargestFont);
  const double size = FontSize ? *FontSize * (InPoints ? point : 1.0) : usual;
  return static_cast<int>(std::clamp(size, kSmallestFont, kLargestFont));
}

void FigureOptions::Check(const ImageSize& size) const
{
  if (Asked && InPoints && !size.inches)
  {
    throw UsageError("--font-size: points have no size in pixels here; give --size in mm or in");
  }
  if (Asked && std::max(size.width, size.height) > RasterCanvas::kMaxSide)
  {
    throw UsageError(fmt::format("--figure: at most {} pixels to a side, and --size has {}",
      RasterCanvas::kMaxSide, std::max(size.width, size.height)));
  }
  const int font = FontOf(size);
  const auto hasRoom = [&](double aspect)
  { return HasRoom(Divide(size, font, !Title.empty(), aspect, false)); };
  if (Asked && !(hasRoom(kMaxBoxAspect) && hasRoom(1.0 / kMaxBoxAspect)))
  {
    throw UsageError(fmt::format("--figure: {} pixels have no room for it with letters of {}; "
                                 "choose a larger --size, or a smaller --font-size",
      size.height > 0 ? fmt::format("{} x {}", size.width, size.height)
                      : std::to_string(size.width),
      font));
  }
}

FigureLayout FigureOptions::LayOut(const ImageSize& size, const Shot& shot, bool turns) const
{
  const int font = FontOf(size);
  const double aspect = AspectOfBox(shot);
  if (Which.value_or(Axes::Coordinates) == Axes::Coordinates && !turns && HasCoordinates(shot))
  {
    const FigureLayout layout = Divide(size, font, !Title.empty(), aspect, true);
    if (HasRoom(layout))
    {
      return layout;
    }
  }
  return Divide(size, font, !Title.empty(), aspect, false);
}

void FigureOptions::NoteEffects(const FigureLayout& layout, const Shot& shot) const
{
  if (Which == Axes::Coordinates && !layout.hasCoordinates)
  {
    Note("--axes coordinates: this view has none, because it is oblique or turns, shows several "
         "surfaces in perspective, or has no room for them");
  }
  if (!LengthUnit.empty() && !layout.hasCoordinates && !HasOneScale(shot))
  {
    Note("--length-unit has no effect: an oblique view has neither coordinates nor a scale");
  }
}

std::vector<FigureBar> FigureOptions::BarsOf(const FigureContent& content) const
{
  const Shot& shot = content.shot;
  const ColorOptions& colors = content.colors;
  std::vector<FigureBar> bars;
  const auto nameOf = [&](const std::string& own, const std::string& unitInFile)
  {
    const std::string& unit = Unit.empty() ? unitInFile : Unit;
    const std::string& name = !BarTitle.empty() && bars.empty() ? BarTitle : own;
    return unit.empty() ? name : name + " [" + unit + "]";
  };
  if (content.bar)
  {
    FigureBar bar = *content.bar;
    bar.name = nameOf(bar.name, {});
    bar.ticks = TickValues;
    bar.tickCount = TickCount;
    bars.push_back(std::move(bar));
  }
  const std::vector<ValueRange>& ranges = content.appearance.Ranges();
  std::vector<std::size_t> shown; // the first layer of each bar
  for (std::size_t k = 0; k < shot.scene.layers.size() && content.hasBars; ++k)
  {
    const auto isSame = [&](std::size_t other)
    {
      return ranges[other] == ranges[k] &&
        shot.settings[other].colormap == shot.settings[k].colormap &&
        NameOf(shot.scene.layers[other]) == NameOf(shot.scene.layers[k]);
    };
    if (!ranges[k] || std::ranges::any_of(shown, isSame))
    {
      continue;
    }
    shown.push_back(k);
    std::vector<ValueRange> own(ranges.size());
    for (std::size_t other = k; other < ranges.size(); ++other)
    {
      own[other] = ranges[other] && isSame(other) ? ranges[k] : std::nullopt;
    }
    const PixelsBeyond beyond = CountBeyond(content.frame, own, colors.Logarithm());
    const Layer& layer = shot.scene.layers[k];
    bars.push_back({ nameOf(NameOf(layer), UnitInFile(shot, layer)), *ranges[k],
      content.appearance.Maps()[k], colors.Logarithm() && (*ranges[k])[0] > 0.0,
      { beyond.below > 0, beyond.above > 0 }, colors.Bands(), TickValues, TickCount });
  }
  return bars;
}

void FigureOptions::WarnOfTicks(const std::vector<FigureBar>& bars) const
{
  const auto isOnBar = [&bars](double value)
  {
    return std::ranges::any_of(bars,
      [value](const FigureBar& bar) { return value >= bar.range[0] && value <= bar.range[1]; });
  };
  if (!bars.empty() && !TickValues.empty() && std::ranges::none_of(TickValues, isOnBar))
  {
    Note(fmt::format("--bar-ticks: none of the values is within {} to {}", Short(bars[0].range[0]),
      Short(bars[0].range[1])));
  }
}

void FigureOptions::DrawLegend(
  FigureLegend& legend, const FigureContent& content, bool hasCoordinates) const
{
  const Shot& shot = content.shot;
  if (Which != Axes::None && !hasCoordinates)
  {
    legend.AddDirections(shot.view);
  }
  const double unit = LengthOfPixel(shot);
  if (!hasCoordinates && unit > 0.0 && std::isfinite(unit))
  {
    legend.AddScale(unit, LengthUnit);
  }
  const FrameCounters& pixels = content.frame.counters;
  if (pixels.unknown > 0)
  {
    legend.AddMark({ LayerColors().unknown, "unknown" });
  }
  for (const ColorMark& mark : content.marks)
  {
    legend.AddMark(mark);
  }
  const std::vector<FigureBar> bars = BarsOf(content);
  if (pixels.nonFinite > 0 && !bars.empty())
  {
    Rgba color{};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    bars.front().map({ &nan, 1 }, color.data());
    color[3] = 255;
    legend.AddMark({ color, "not a number" });
  }
  if (!shot.input.times.empty())
  {
    const auto step = static_cast<std::size_t>(shot.input.step);
    legend.AddText("t = " + WithMinus(Short(shot.input.times[step])));
  }
  if (content.arrow)
  {
    legend.AddArrow(*content.arrow);
  }
  WarnOfTicks(bars);
  legend.AddBars(bars);
}

void FigureOptions::Draw(Canvas& canvas, const FigureContent& content) const
{
  const FigureLayout& layout = *content.shot.layout;
  const Rgba ink = InkOn(content.colors.BackgroundColor());
  if (!Title.empty())
  {
    // Over the middle of the picture, or where the title ends within the figure.
    const double room = layout.size.width - static_cast<double>(layout.font);
    const double half = 0.5 * std::min(canvas.WidthOf(Title), room) + 0.5 * layout.font;
    const double middle = layout.corner[0] + 0.5 * layout.picture.width;
    canvas.WriteWithin(Title, std::clamp(middle, half, layout.size.width - half),
      layout.size.height - 0.5 * kTitle * layout.font, TextAnchor::Centre, room, ink);
  }
  const bool hasCoordinates = layout.hasCoordinates && HasCoordinates(content.shot);
  if (hasCoordinates)
  {
    DrawCoordinates(canvas, layout, content.shot, LengthUnit, ink);
  }
  FigureLegend legend(canvas, layout, ink);
  DrawLegend(legend, content, hasCoordinates);
}

nlohmann::ordered_json ToJson(const FigureLayout& layout)
{
  return { { "width", layout.size.width }, { "height", layout.size.height },
    { "picture", layout.corner }, { "font", layout.font },
    { "legend", layout.legendBelow ? "below" : "right" },
    { "coordinates", layout.hasCoordinates } };
}
} // namespace pixelexact
