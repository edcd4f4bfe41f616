// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Looks.h"

#include "Scene/ColorOptions.h"
#include "Scene/Shot.h"

#include "Core/Faces/FaceTable.h"
#include "HighOrderModel.h"
#include "Views/VtkLook.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
/// Where nothing else is said, of layers without a field.
constexpr std::array<double, 3> kNoField{ 0.6, 0.7, 0.8 };

/// The colour in the place of the map's; none: by value.
std::optional<std::array<double, 3>> SolidOf(
  const ColorOptions& colors, const Layer& layer, const LayerSettings& settings)
{
  if (settings.color)
  {
    return settings.color;
  }
  // A layer that asks for a map has one.
  if (colors.Solid() && !settings.colormap && !settings.range)
  {
    return colors.Solid();
  }
  return layer.field == nullptr ? std::optional(kNoField) : std::nullopt;
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
  return Buffer::Verdict |
    (shot.scene.layers.front().field != nullptr ? Buffer::Value : Buffer::None) |
    (shot.scene.layers.size() > 1 ? Buffer::Layer : Buffer::None) |
    (AnyLit(shot) ? Buffer::Position | Buffer::Normal : Buffer::None) |
    (shot.edges ? ElementEdges(*shot.edges).Needs().centres : Buffer::None) |
    (shot.outlines ? ElementOutlines().Needs().centres : Buffer::None);
}

Looks::Looks(const ColorOptions& colors, const Shot& shot, const Frame& frame)
{
  const std::vector<Layer>& layers = shot.scene.layers;
  std::vector<LayerColors> looks;
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    const LayerSettings& settings = shot.settings[k];
    if (const auto solid = SolidOf(colors, layers[k], settings))
    {
      TheRanges.emplace_back();
      TheMaps.push_back(SolidColor(ToRgba(solid->data())));
    }
    else
    {
      TheRanges.emplace_back(
        RangeOfLayer(settings.range.value_or(colors.Range()), shot, k, frame, colors.Logarithm()));
      TheMaps.push_back(colors.MapOver(*TheRanges.back(), settings.colormap));
    }
    looks.push_back({ .map = TheMaps.back(),
      .opacity = settings.opacity,
      .readsValues = layers[k].field != nullptr });
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
  if (shot.edges)
  {
    KindOfFace kinds;
    if (shot.edgesByKind)
    {
      const FaceTable& faces = shot.input.model->Faces();
      kinds = [&faces](int element, int face) { return faces.KindOf(element, face); };
    }
    Edges.emplace(*shot.edges, std::move(kinds));
  }
  if (shot.outlines)
  {
    Outlines.emplace(ToRgba(shot.outlines->data()));
  }
}

Pipeline Looks::MakePipeline(bool edges)
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
  if (Edges && edges)
  {
    pipeline.modules.push_back(&*Edges);
  }
  if (Outlines)
  {
    pipeline.modules.push_back(&*Outlines);
  }
  return pipeline;
}
} // namespace pixelexact
