// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/Figure.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Report.h"
#include "Drawing/Canvas.h"
#include "Picture/FigureColumn.h"
#include "Scene/ColorOptions.h"
#include "Scene/Shot.h"
#include "Scene/ShotAppearance.h"

#include "Trace/Surfaces/Surface.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr double kSmallestFont = 8.0;
constexpr double kLargestFont = 200.0;
constexpr double kPointsPerInch = 72.0;
constexpr double kDefaultPoints = 7.0;
constexpr double kSmallestPoints = 4.0;
/// Height of a title, in units of the font's size.
constexpr int kTitle = 3;
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

/// One bar for layers with equal colours.
std::vector<FigureBar> BarsOf(const Shot& shot, const ShotAppearance& appearance)
{
  std::vector<FigureBar> bars;
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const auto& range = appearance.Ranges()[k];
    if (!range)
    {
      continue;
    }
    const auto colormap = shot.settings[k].colormap;
    const std::string name = NameOf(shot.scene.layers[k]);
    bool isNew = true;
    for (std::size_t other = 0; other < k && isNew; ++other)
    {
      isNew = appearance.Ranges()[other] != range || shot.settings[other].colormap != colormap ||
        NameOf(shot.scene.layers[other]) != name;
    }
    if (isNew)
    {
      bars.push_back({ name, *range, &appearance.Maps()[k] });
    }
  }
  return bars;
}

/// The length of a pixel in world units where it is the same in the whole picture, else 0.
double UnitOf(const Shot& shot)
{
  const CameraView& view = shot.view;
  if (view.parallel)
  {
    return 2.0 * view.parallelScale / shot.size.height;
  }
  const Surface& surface = *shot.scene.layers.front().surface;
  const Vec3 towards = glm::normalize(view.position - view.focalPoint);
  if (shot.scene.layers.size() > 1 || !surface.IsFlat() ||
    std::fabs(glm::dot(surface.Normal({ view.focalPoint }), towards)) < 1.0 - 1e-9)
  {
    return 0.0;
  }
  const auto hits =
    HitsOf(surface, shot.MakeCamera().At(0.5 * shot.size.width, 0.5 * shot.size.height));
  return hits.empty() ? 0.0
                      : 2.0 * glm::distance(hits.front().position, view.position) *
      std::tan(0.5 * glm::radians(view.viewAngle)) / shot.size.height;
}
} // namespace

void FigureOptions::AddTo(CLI::App& command)
{
  Bind(command, "--figure", Asked);
  Bind(command, "--title", Title);
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
  const double usual =
    figure.inches ? kDefaultPoints * point : std::clamp(figure.height / 40.0, 10.0, kLargestFont);
  const double size = FontSize ? *FontSize * (InPoints ? point : 1.0) : usual;
  return static_cast<int>(std::clamp(size, kSmallestFont, kLargestFont));
}

Rgba InkOn(const Rgba& background)
{
  const double light = 0.299 * background[0] + 0.587 * background[1] + 0.114 * background[2];
  return light > 127.0 ? Rgba{ 0, 0, 0, 255 } : Rgba{ 255, 255, 255, 255 };
}

ImageSize FigureOptions::PictureSize(const ImageSize& figure) const
{
  const int font = FontOf(figure);
  return { figure.width - FigureColumn::kWidth * font,
    figure.height - (Title.empty() ? 0 : kTitle * font), {} };
}

void FigureOptions::Check(const ImageSize& size) const
{
  if (Asked && InPoints && !size.inches)
  {
    throw UsageError("--font-size: points have no size in pixels here; give --size in mm or in");
  }
  const ImageSize picture = PictureSize(size);
  if (Asked && (picture.width < kMin || picture.height < kMin || size.height < 18 * FontOf(size)))
  {
    throw UsageError(fmt::format("--figure: {} x {} pixels have no room for it with letters of {}; "
                                 "choose a larger --size, or a smaller --font-size",
      size.width, size.height, FontOf(size)));
  }
}

void FigureOptions::Draw(
  Canvas& canvas, const ImageSize& figure, const FigureContent& content) const
{
  const auto& [shot, appearance, frame, colors, bars, marks] = content;
  const int font = FontOf(figure);
  const Rgba ink = InkOn(colors.BackgroundColor());
  if (!Title.empty())
  {
    canvas.Write(
      Title, 0.5 * figure.width, figure.height - 0.5 * kTitle * font, TextAnchor::Centre, ink);
  }
  FigureColumn column(canvas, figure.width - FigureColumn::kWidth * font + font, font, ink);
  // From below: axes, scale, colours without a value, time. The bars use the remaining height.
  double y = 3.5 * font;
  column.DrawAxes(shot.view, y);
  y += 4.0 * font;
  if (const double unit = UnitOf(shot); unit > 0.0 && std::isfinite(unit))
  {
    column.DrawScale(unit, y);
    y += 2.5 * font;
  }
  const FrameCounters& pixels = frame.counters;
  if (pixels.unknown > 0)
  {
    column.DrawMark(LayerColors().unknown, "unknown", y);
    y += 1.6 * font;
  }
  for (const ColorMark& mark : marks)
  {
    column.DrawMark(mark.color, mark.text, y);
    y += 1.6 * font;
  }
  const std::vector<FigureBar> all = bars ? BarsOf(shot, appearance) : std::vector<FigureBar>();
  if (pixels.nonFinite > 0 && !all.empty())
  {
    Rgba color{};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    (*all.front().map)({ &nan, 1 }, color.data());
    color[3] = 255;
    column.DrawMark(color, "not a number", y);
    y += 1.6 * font;
  }
  if (!shot.input.times.empty())
  {
    const auto step = static_cast<std::size_t>(shot.input.step);
    column.Write("t = " + Short(shot.input.times[step]), y);
    y += 1.6 * font;
  }
  double top = frame.height - 0.5 * font;
  const double share = (top - y) / std::max<std::size_t>(1, all.size());
  for (const FigureBar& bar : all)
  {
    column.Write(bar.name, top - font);
    const double height = std::min(share - 3.5 * font, 0.6 * figure.height);
    column.DrawBar(bar, static_cast<int>(top - 2.5 * font),
      std::max(font, static_cast<int>(height)), colors.Logarithm() && bar.range[0] > 0.0,
      colors.Bands());
    top -= share;
  }
}
} // namespace pixelexact
