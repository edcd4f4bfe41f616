// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameContours.h"

#include "ContourList.h"
#include "Frames/ContourLabels.h"
#include "Views/FieldRange.h"

#include "Core/Base/Error.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/FrameTiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pixelexact
{
std::vector<double> ContourValuesOver(int count, const std::array<double, 2>& range, bool logarithm,
  const Field* field, const std::optional<std::array<double, 2>>& seen)
{
  std::vector<double> values = RoundValues(count, range, logarithm);
  if (field != nullptr && seen && IsOneValue(*field, *seen))
  {
    const std::array<double, 2> wide = BeyondRounding(*field, *seen);
    std::erase_if(values, [&wide](double value) { return value >= wide[0] && value <= wide[1]; });
  }
  return values;
}

std::optional<std::array<double, 2>> ValuesSeen(const Frame& frame, std::size_t layer)
{
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  const auto add = [&](const SampleBuffers& sheet)
  {
    for (std::size_t i = 0; i < sheet.value.size(); ++i)
    {
      const bool exact = sheet.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact);
      if (exact && std::isfinite(sheet.value[i]) &&
        (sheet.layer.empty() ? 0U : sheet.layer[i]) == layer)
      {
        lower = std::min(lower, sheet.value[i]);
        upper = std::max(upper, sheet.value[i]);
      }
    }
  };
  add(frame.centres);
  std::ranges::for_each(frame.centres.behind, add);
  return lower <= upper ? std::optional(std::array{ lower, upper }) : std::nullopt;
}

void FrameContours::Make(const Scene& scene, const std::vector<LayerContours>& layers,
  const std::vector<ColorMap>& maps, const ContourLook& look)
{
  Lines.reset();
  Certifier.reset();
  Labels.reset();
  std::vector<std::vector<double>> values;
  std::vector<std::vector<Rgba>> lineColors;
  ContourStyle style = look.style;
  style.curved = false;
  bool any = false;
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    const LayerContours& layer = layers[k];
    values.push_back(layer.values);
    lineColors.push_back(layer.colors.empty() ? ColorsOf(layer.values, maps[k])
                                              : InOrderOf(layer.values, layer.colors));
    if (!layer.Any())
    {
      continue;
    }
    any = true;
    if (scene.layers[k].field == nullptr)
    {
      throw Error("contours: the data have no field; set the number of contours to 0");
    }
    style.curved = style.curved || !scene.layers[k].surface->IsFlat();
  }
  if (!any)
  {
    return;
  }
  if (look.labels)
  {
    RequireLabelSize(*look.labels);
  }
  const bool translucent = HasTranslucent(scene);
  Labels = translucent ? std::nullopt : look.labels;
  style.onSheet = translucent;
  style.keepBeneath = Labels.has_value();
  if (!Bounds)
  {
    Bounds = std::make_shared<ContourBounds>();
  }
  ContourMethod method;
  method.interior = look.interior;
  method.SetEffort(look.effort);
  Certifier.emplace(std::move(values), method, Bounds);
  Lines.emplace(*Certifier, style, std::move(lineColors));
}

void FrameContours::AddTo(Pipeline& pipeline)
{
  if (Lines)
  {
    pipeline.modules.push_back(&*Certifier);
    pipeline.modules.push_back(&*Lines);
  }
}

Buffer FrameContours::NeedsOfLabels() const
{
  // Normals tell where a surface hides a part of itself.
  return Labels ? Buffer::Value | Buffer::Position | Buffer::Normal : Buffer::None;
}

void FrameContours::Finish(Frame& frame, const Camera& camera) const
{
  if (Labels)
  {
    DrawContourLabels(frame, camera, *Certifier, *Lines, *Labels);
  }
}
} // namespace pixelexact
