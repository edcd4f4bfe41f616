// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameContours.h"

#include "Frames/ContourLabels.h"

#include "Core/Base/Error.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/FrameTiles.h"

#include <utility>

namespace pixelexact
{
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
    if (layer.values.empty())
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
