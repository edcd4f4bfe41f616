// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Look/Painter.h"

#include "Core/Faces/FaceTable.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/FrameTiles.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
KindOfFace KindsOf(const FaceTable* faces)
{
  return faces == nullptr ? KindOfFace()
                          : [faces](int element, int face) { return faces->KindOf(element, face); };
}

bool HasLabels(const ViewLook& look, const Scene& scene)
{
  return look.HasContours() && look.contours.labels && !(look.bySheets && HasTranslucent(scene));
}

std::vector<std::optional<Material>> MaterialsOf(const ViewLook& look)
{
  std::vector<std::optional<Material>> materials;
  for (const LayerLook& layer : look.layers)
  {
    materials.push_back(layer.material);
  }
  return materials;
}
} // namespace

Painter::Painter(const ViewLook& look, const Scene& scene, const ResolvedLook& resolved,
  std::shared_ptr<ContourBounds> bounds)
{
  std::vector<LayerColors> colors;
  for (std::size_t k = 0; k < look.layers.size(); ++k)
  {
    const LayerLook& layer = look.layers[k];
    const bool inOne = look.contours.only && look.HasContours();
    colors.push_back({ inOne ? SolidColor(*look.contours.only) : resolved.layers[k].map,
      layer.unknown, inOne ? 1.0 : layer.opacity, !inOne && !layer.solid });
  }
  Colors.emplace(std::move(colors));
  if (look.IsLit() && !look.contours.only)
  {
    Lights = std::make_unique<Lighting>(MaterialsOf(look), look.lights, look.lit);
  }
  if (look.samples > 1)
  {
    Smooth.emplace(look.samples);
  }
  if (look.edges)
  {
    Edges.emplace(*look.edges, KindsOf(look.faces));
  }
  if (look.outlines)
  {
    Outlines.emplace(*look.outlines);
  }
  if (look.HasContours())
  {
    MakeContours(look, scene, resolved, std::move(bounds));
  }
}

void Painter::MakeContours(const ViewLook& look, const Scene& scene, const ResolvedLook& resolved,
  std::shared_ptr<ContourBounds> bounds)
{
  std::vector<std::vector<double>> values;
  std::vector<std::vector<Rgba>> colors;
  ContourStyle style = look.contours.style;
  style.curved = false;
  for (std::size_t k = 0; k < look.layers.size(); ++k)
  {
    values.push_back(resolved.layers[k].contours);
    colors.push_back(resolved.layers[k].contourColors);
    style.curved = style.curved || (!values.back().empty() && !scene.layers[k].surface->IsFlat());
  }
  TheLabels = HasLabels(look, scene) ? look.contours.labels : std::nullopt;
  style.onSheet = look.bySheets && HasTranslucent(scene);
  style.keepBeneath = TheLabels.has_value();
  Certifier.emplace(std::move(values), look.contours.method, std::move(bounds));
  TheLines.emplace(*Certifier, style, std::move(colors));
}

Pipeline Painter::MakePipeline(const Drawn& drawn)
{
  Pipeline pipeline{ { &*Colors }, {} };
  if (Lights)
  {
    pipeline.colors.push_back(Lights.get());
  }
  if (Smooth)
  {
    pipeline.modules.push_back(&*Smooth);
  }
  // Behind anti-aliasing, so that nothing smooths them.
  if (Edges && drawn.edges)
  {
    pipeline.modules.push_back(&*Edges);
  }
  if (Outlines)
  {
    pipeline.modules.push_back(&*Outlines);
  }
  // Last, so that nothing is drawn over them.
  if (Certifier)
  {
    pipeline.modules.push_back(&*Certifier);
  }
  if (TheLines && drawn.contours)
  {
    pipeline.modules.push_back(&*TheLines);
  }
  return pipeline;
}

Buffer NeedsOf(const ViewLook& look, const Scene& scene, bool afterwards)
{
  const bool byValue =
    std::ranges::any_of(look.layers, [](const LayerLook& layer) { return !layer.solid; });
  // Normals tell labels where a surface hides a part of itself.
  const Buffer ofLabels =
    HasLabels(look, scene) ? Buffer::Value | Buffer::Position | Buffer::Normal : Buffer::None;
  const Buffer ofContours = afterwards && look.HasContours()
    ? ContourCertifier({}, look.contours.method).Needs().welcome | Buffer::Layer
    : Buffer::None;
  return Buffer::Verdict | NeedsOfRules(look, scene) | ofContours | ofLabels |
    (byValue ? Buffer::Value : Buffer::None) |
    (scene.layers.size() > 1 ? Buffer::Layer : Buffer::None) |
    (look.IsLit() ? Buffer::Position | Buffer::Normal : Buffer::None) |
    (look.edges ? ElementEdges(*look.edges).Needs().centres : Buffer::None) |
    (look.outlines ? ElementOutlines().Needs().centres : Buffer::None);
}
} // namespace pixelexact
