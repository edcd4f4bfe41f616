// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/DifferencePicture.h"

#include "Drawing/Picture.h"
#include "Drawing/VectorCanvas.h"
#include "Scene/Shot.h"
#include "Scene/ShotAppearance.h"
#include "Trade/DifferenceOptions.h"

#include "Frames/DifferenceImage.h"

#include <vtkImageData.h>

#include <algorithm>
#include <optional>

namespace pixelexact
{
namespace
{
// Neither is in the map that is usual for differences, blue to red.
constexpr Rgba kOnlyFirst{ 60, 160, 70, 255 };
constexpr Rgba kOnlySecond{ 235, 190, 40, 255 };

void PaintSides(FieldDifference& difference)
{
  std::vector<std::uint8_t>& colors = difference.frame.centres.color;
  for (std::size_t i = 0; i < difference.side.size(); ++i)
  {
    const auto side = static_cast<DifferenceSide>(difference.side[i]);
    if (side == DifferenceSide::First || side == DifferenceSide::Second)
    {
      std::ranges::copy(side == DifferenceSide::First ? kOnlyFirst : kOnlySecond, &colors[4 * i]);
    }
  }
}

/// The shot as if the difference were its field: for bars and ranges.
struct ShownAs
{
  ShownAs(const Shot& shot, const ShotOptions& options, const std::string& other)
    : field(*shot.scene.layers.front().field)
    , shown(shot)
  {
    field.name = field.name == other ? "difference of " + other : field.name + " - " + other;
    Layer& layer = shown.scene.layers.front();
    layer.field = &field;
    const bool norm = layer.component == kMagnitude && field.values.components > 1;
    LayerSettings& settings = shown.settings.front();
    if (!norm && !IsGiven(*options.command, "--range"))
    {
      settings.range = RangeRule{ RangeRule::Of::Cut, {}, true };
    }
    if (!norm && !IsGiven(*options.command, "--colormap"))
    {
      settings.colormap = "coolwarm";
    }
  }

  Field field;
  Shot shown;
};
} // namespace

DifferencePicture::DifferencePicture(const ShotOptions& options, const Shot& shot,
  const std::string& field, FieldDifference& difference)
  : Options(options)
  , Of(shot)
  , Shown(difference)
  , Other(field)
{
  const ShownAs as(shot, options, Other);
  ShotAppearance appearance(options.colors, nullptr, as.shown, difference.frame);
  range_ = *appearance.Ranges().front();
  Repaint(appearance.GetPainter().MakePipeline(), difference.frame);
  PaintSides(difference);
}

std::string DifferencePicture::Encode(
  const DifferenceOptions& difference, const PictureTexts& texts, const std::string& file) const
{
  const ColorOptions& colors = Options.colors;
  const ShownAs as(Of, Options, Other);
  const ShotAppearance appearance(colors, nullptr, as.shown, Shown.frame);
  const FigureOptions& figure = difference.Figure();
  FigureContent content{ as.shown, appearance, Shown.frame, colors, true, {}, {}, {} };
  const auto mark = [&](DifferenceSide side, const Rgba& color, const char* text)
  {
    if (std::ranges::find(Shown.side, static_cast<std::uint8_t>(side)) != Shown.side.end())
    {
      content.marks.push_back({ color, text });
    }
  };
  mark(DifferenceSide::Second, kOnlySecond, "only second");
  mark(DifferenceSide::First, kOnlyFirst, "only first");
  const PictureFormat format = FormatOf("--output", file);
  const FigureLayout& layout = *Of.layout;
  const auto draw = [&](Canvas& canvas)
  {
    canvas.MoveOrigin(layout.corner[0], layout.corner[1]);
    canvas.Place(colors.Flatten(Shown.frame));
    canvas.MoveOrigin(-layout.corner[0], -layout.corner[1]);
    figure.Draw(canvas, content);
  };
  if (IsVector(format))
  {
    VectorCanvas canvas(format, layout.size.width, layout.size.height, kDefaultDpi,
      colors.BackgroundColor(), layout.font, difference.Font().Choice());
    draw(canvas);
    return canvas.Finish(texts, file);
  }
  RasterCanvas canvas(layout.size.width, layout.size.height, colors.BackgroundColor(), layout.font,
    difference.Font().Choice());
  draw(canvas);
  const auto dpi = layout.size.inches ? std::optional(kDefaultDpi) : std::nullopt;
  return EncodeImage(canvas.Picture(), format, { dpi, texts }, file);
}

void WriteDifference(const std::string& file, const FieldDifference& difference,
  std::span<const std::int64_t> firstCells, std::span<const std::int64_t> secondCells)
{
  const vtkSmartPointer<vtkImageData> image = ToImageData(difference, firstCells, secondCells);
  WriteImage(file, image);
}
} // namespace pixelexact
