// SPDX-License-Identifier: BSD-3-Clause
#include "Looks.h"

#include "ColorOptions.h"
#include "Shot.h"

#include "VtkLook.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
bool ShowTheSame(const Layer& a, const Layer& b)
{
  return a.field == b.field && a.component == b.component;
}

bool IsLit(const Shot& shot, std::size_t layer)
{
  const bool unasked = !shot.scene.layers[layer].surface->IsFlat() && shot.lights != Lit::Off;
  return shot.settings[layer].lights.value_or(unasked || shot.lights == Lit::On);
}

bool AnyLit(const Shot& shot)
{
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    if (IsLit(shot, k))
    {
      return true;
    }
  }
  return false;
}

/// A light at the eye, as a new vtkRenderer has.
Lighting HeadlightOf(const Shot& shot)
{
  std::vector<std::optional<Material>> materials(shot.scene.layers.size());
  for (std::size_t k = 0; k < materials.size(); ++k)
  {
    if (IsLit(shot, k))
    {
      materials[k].emplace();
    }
  }
  LitView view;
  view.eye = shot.view.position;
  view.direction = shot.MakeCamera().ViewDirection();
  view.parallel = shot.view.parallel;
  return { materials, { Light{ .headlight = true } }, view };
}
} // namespace

Buffer NeedsOfLooks(const Shot& shot)
{
  return Buffer::Value | Buffer::Verdict |
    (shot.scene.layers.size() > 1 ? Buffer::Layer : Buffer::None) |
    (AnyLit(shot) ? Buffer::Position | Buffer::Normal : Buffer::None) |
    (shot.outlines ? ElementOutlines().Needs().centres : Buffer::None);
}

Looks::Looks(const ColorOptions& colors, const Shot& shot, const Frame& frame)
{
  const std::vector<Layer>& layers = shot.scene.layers;
  std::vector<LayerColors> looks;
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    const LayerSettings& settings = shot.settings[k];
    std::vector<bool> together;
    together.reserve(layers.size());
    for (const Layer& other : layers)
    {
      together.push_back(ShowTheSame(other, layers[k]));
    }
    TheRanges.push_back(settings.range.value_or(colors.RangeFor(frame, together)));
    TheMaps.push_back(settings.color ? SolidColor(ToRgba(settings.color->data()))
                                     : colors.MapOver(TheRanges.back(), settings.colormap));
    looks.push_back({ .map = TheMaps.back(), .opacity = settings.opacity });
  }
  Colors.emplace(std::move(looks));
  if (AnyLit(shot))
  {
    Lights.emplace(HeadlightOf(shot));
  }
  if (shot.samples > 1)
  {
    Smooth.emplace(shot.samples);
  }
  if (shot.outlines)
  {
    Outlines.emplace(ToRgba(shot.outlines->data()));
  }
}

Pipeline Looks::MakePipeline()
{
  Pipeline pipeline{ { &*Colors }, {} };
  if (Lights)
  {
    pipeline.colors.push_back(&*Lights);
  }
  if (Smooth)
  {
    pipeline.modules.push_back(&*Smooth);
  }
  // Last, so that nothing smooths them.
  if (Outlines)
  {
    pipeline.modules.push_back(&*Outlines);
  }
  return pipeline;
}
} // namespace pixelexact
