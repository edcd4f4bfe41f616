// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/ContourDrawing.h"

#include "Frames/FrameContours.h"
#include "Scene/ColorOptions.h"
#include "Scene/ContourOptions.h"
#include "Scene/Looks.h"
#include "Scene/Shot.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
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
    values.push_back(choice.count > 0 ? ContourValuesOver(choice.count, *range, colors.Logarithm(),
                                          shot.scene.layers[k].field, ValuesSeen(frame, k))
                                      : choice.values);
    OfOneValue = OfOneValue || values.back().size() < choice.Count();
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
    const auto seen = ValuesSeen(frame, k);
    found.outside += static_cast<std::size_t>(std::ranges::count_if(found.values[k],
      [&seen](double value) { return !seen || value < (*seen)[0] || value > (*seen)[1]; }));
  }
  return found;
}
} // namespace pixelexact
