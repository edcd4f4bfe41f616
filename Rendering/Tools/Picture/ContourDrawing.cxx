// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ContourDrawing.h"

#include "Drawing/Ticks.h"
#include "Scene/ColorOptions.h"
#include "Scene/ContourOptions.h"
#include "Scene/Looks.h"
#include "Scene/Shot.h"
#include "Views/FieldRange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
/// Evenly spaced, both ends among them; one alone is the first.
std::vector<double> Spaced(int count, const std::array<double, 2>& range, bool logarithm)
{
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    const double part = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
    const bool end = i == 0 || i + 1 == count;
    values.push_back(logarithm && !end
        ? std::pow(10.0, std::lerp(std::log10(range[0]), std::log10(range[1]), part))
        : std::lerp(range[0], range[1], part));
  }
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// At the centres of a layer's own pixels.
std::optional<std::array<double, 2>> ValuesSeen(
  const Frame& frame, std::size_t layer, std::size_t layers)
{
  std::vector<bool> alone(layers, false);
  alone[layer] = true;
  return ValueRange(frame, -std::numeric_limits<double>::infinity(), alone);
}
} // namespace

std::vector<double> ContourValues(
  const ContourChoice& choice, const std::array<double, 2>& range, bool logarithm)
{
  if (choice.count == 0)
  {
    return choice.values;
  }
  if (!choice.round)
  {
    return Spaced(choice.count, range, logarithm);
  }
  std::vector<double> values;
  for (const Tick& tick : TicksWithin(range, logarithm && range[0] > 0.0, choice.count))
  {
    values.push_back(tick.value);
  }
  return values;
}

ContourDrawing::ContourDrawing(const ContourOptions& options, const ColorOptions& colors,
  const Shot& shot, const Looks& looks, const Frame& frame, std::shared_ptr<ContourBounds> bounds)
{
  std::vector<std::vector<double>> values;
  std::vector<std::vector<Rgba>> lineColors;
  ContourStyle style = options.Style();
  style.curved = false;
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const LayerSettings& settings = shot.settings[k];
    const ContourChoice choice = settings.contours.value_or(options.OfAll());
    std::optional<std::array<double, 2>> range = looks.Ranges()[k];
    if (!range && (choice.count > 0 || options.ByMap()))
    {
      // One that is painted in one colour has no map.
      range =
        RangeOfLayer(settings.range.value_or(colors.Range()), shot, k, frame, colors.Logarithm());
    }
    values.push_back(
      choice.count > 0 ? ContourValues(choice, *range, colors.Logarithm()) : choice.values);
    if (choice.count > 0)
    {
      DropRounding(
        shot.scene.layers[k], ValuesSeen(frame, k, shot.scene.layers.size()), values.back());
    }
    lineColors.push_back(options.ByMap()
        ? ColorsOf(values.back(),
            looks.Ranges()[k] ? looks.Maps()[k] : colors.MapOver(*range, settings.colormap))
        : InOrderOf(values.back(), options.Colors()));
    style.curved =
      style.curved || (!values.back().empty() && !shot.scene.layers[k].surface->IsFlat());
  }
  LabelHeight = options.Labels();
  Interior = options.HowTold().interior;
  Certifier.emplace(std::move(values), options.HowTold(), std::move(bounds));
  Lines.emplace(*Certifier, style, std::move(lineColors));
  if (options.Only())
  {
    InPlace.emplace(std::vector<LayerColors>(shot.scene.layers.size(),
      { .map = SolidColor(colors.BackgroundColor()), .readsValues = false }));
  }
}

void ContourDrawing::DropRounding(
  const Layer& layer, const std::optional<std::array<double, 2>>& seen, std::vector<double>& values)
{
  if (layer.field == nullptr || !seen || !IsOneValue(*layer.field, *seen))
  {
    return;
  }
  const std::array<double, 2> wide = BeyondRounding(*layer.field, *seen);
  OfOneValue = std::erase_if(values,
                 [&](double value)
                 {
                   const bool isSeen = value >= (*seen)[0] && value <= (*seen)[1];
                   return value >= wide[0] && value <= wide[1] && !isSeen;
                 }) > 0 ||
    OfOneValue;
}

void ContourDrawing::AddTo(Pipeline& pipeline, bool lines)
{
  if (InPlace)
  {
    pipeline.colors = { &*InPlace };
  }
  pipeline.modules.push_back(&*Certifier);
  if (lines)
  {
    pipeline.modules.push_back(&*Lines);
  }
}

void ContourDrawing::DrawLabels(const Shot& shot, const FontChoice& font, Frame& frame)
{
  if (LabelHeight)
  {
    Labels = DrawContourLabels(frame, shot.MakeCamera(), *Certifier, *Lines, *LabelHeight, font);
  }
}

std::vector<ContourLabel> ContourDrawing::PlaceLabels(
  const Shot& shot, const FontChoice& font, const Frame& frame)
{
  if (!LabelHeight)
  {
    return {};
  }
  std::vector<ContourLabel> labels =
    PlaceContourLabels(frame, shot.MakeCamera(), *Certifier, *Lines, *LabelHeight, font);
  Labels = static_cast<int>(labels.size());
  return labels;
}

FoundContours ContourDrawing::Found(const Frame& frame) const
{
  FoundContours found{ Certifier->Values(), 0, Certifier->Counters(),
    LabelHeight ? std::optional(Labels) : std::nullopt, Interior, OfOneValue };
  for (std::size_t k = 0; k < found.values.size(); ++k)
  {
    const auto seen = ValuesSeen(frame, k, found.values.size());
    found.outside += static_cast<std::size_t>(std::ranges::count_if(found.values[k],
      [&seen](double value) { return !seen || value < (*seen)[0] || value > (*seen)[1]; }));
  }
  return found;
}
} // namespace pixelexact
