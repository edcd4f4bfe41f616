// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Appearance/Painter.h"

#include "Core/Base/Error.h"
#include "Core/Faces/FaceTable.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/View.h"

#include <algorithm>
#include <iterator>
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

bool HasLabels(const View& view)
{
  const Appearance& appearance = view.appearance;
  return appearance.HasContours() && appearance.contours.labels &&
    !(appearance.bySheets && HasTranslucent(view.scene));
}

/// Pixels whose colour is not proven have a colour of their own.
bool MarksUndecided(const Appearance& appearance)
{
  return appearance.undecided && appearance.IsByValue() && !appearance.HasContoursOnly();
}

/// Throws Error for what the module cannot place in a volume.
void RequireVolumeAlone(const View& view)
{
  const Appearance& appearance = view.appearance;
  if (appearance.samples > 1 || view.stride > 1)
  {
    throw Error("volume: it has one ray for each pixel; leave out samples and stride");
  }
  if (HasTranslucent(view.scene) &&
    (appearance.edges || appearance.outlines || appearance.HasContours()))
  {
    throw Error("volume: lines on translucent surfaces have no place in it; make the surfaces "
                "opaque, or leave out edges, outlines and contours");
  }
}

std::vector<ColorMap> MapsOf(const ResolvedAppearance& resolved)
{
  std::vector<ColorMap> maps;
  std::ranges::transform(resolved.layers, std::back_inserter(maps), &ResolvedLayer::map);
  return maps;
}

std::vector<std::optional<Material>> MaterialsOf(const Appearance& appearance)
{
  std::vector<std::optional<Material>> materials;
  for (const LayerAppearance& layer : appearance.layers)
  {
    materials.push_back(layer.material);
  }
  return materials;
}
} // namespace

Painter::Painter(
  const View& view, const ResolvedAppearance& resolved, std::shared_ptr<ContourBounds> bounds)
{
  const Appearance& appearance = view.appearance;
  const bool inOne = appearance.HasContoursOnly();
  std::vector<LayerColors> colors;
  for (std::size_t k = 0; k < appearance.layers.size(); ++k)
  {
    const LayerAppearance& layer = appearance.layers[k];
    colors.push_back({ inOne ? SolidColor(*appearance.contours.only) : resolved.layers[k].map,
      layer.unknown, inOne ? 1.0 : layer.opacity, !inOne && !layer.solid });
  }
  Colors.emplace(std::move(colors));
  if (appearance.IsLit() && !appearance.contours.only)
  {
    Lights = std::make_unique<Lighting>(MaterialsOf(appearance), appearance.lights, appearance.lit);
  }
  if (MarksUndecided(appearance))
  {
    if (appearance.samples > 1)
    {
      throw Error("samples mix the colour of undecided pixels with others; leave out one of them");
    }
    Unproven = std::make_unique<UndecidedColors>(MapsOf(resolved), *appearance.undecided);
  }
  if (appearance.samples > 1)
  {
    Smooth.emplace(appearance.samples);
  }
  if (appearance.edges)
  {
    Edges.emplace(*appearance.edges, KindsOf(appearance.faces));
  }
  if (appearance.outlines)
  {
    Outlines.emplace(*appearance.outlines);
  }
  if (appearance.HasContours())
  {
    MakeContours(view, resolved, std::move(bounds));
  }
  if (view.volume)
  {
    RequireVolumeAlone(view);
    volume_ = std::make_unique<VolumeDrawing>(*view.volume);
  }
}

Painter::~Painter() = default;

void Painter::MakeContours(
  const View& view, const ResolvedAppearance& resolved, std::shared_ptr<ContourBounds> bounds)
{
  const Appearance& appearance = view.appearance;
  const Scene& scene = view.scene;
  std::vector<std::vector<double>> values;
  std::vector<std::vector<Rgba>> colors;
  ContourStyle style = appearance.contours.style;
  style.curved = false;
  style.showUndecided = style.showUndecided || appearance.undecided;
  for (std::size_t k = 0; k < appearance.layers.size(); ++k)
  {
    values.push_back(resolved.layers[k].contours);
    colors.push_back(resolved.layers[k].contourColors);
    // The flag includes layers whose values are not resolved yet, because the traced buffers depend
    // on it.
    const bool any = appearance.layers[k].contours.Any();
    style.curved = style.curved || (any && !scene.layers[k].surface->IsFlat());
  }
  labels_ = HasLabels(view) ? appearance.contours.labels : std::nullopt;
  style.onSheet = appearance.bySheets && HasTranslucent(scene);
  style.keepBeneath = labels_.has_value();
  Certifier.emplace(std::move(values), appearance.contours.method, std::move(bounds));
  lines_.emplace(*Certifier, style, std::move(colors));
}

Pipeline Painter::MakePipeline(const Drawn& drawn)
{
  Pipeline pipeline{ { &*Colors }, {} };
  if (Lights)
  {
    pipeline.colors.push_back(Lights.get());
  }
  if (Unproven)
  {
    pipeline.colors.push_back(Unproven.get());
  }
  if (Smooth)
  {
    pipeline.modules.push_back(&*Smooth);
  }
  // Edges come after anti-aliasing, which would smooth them.
  if (Edges && drawn.edges)
  {
    pipeline.modules.push_back(&*Edges);
  }
  if (Outlines)
  {
    pipeline.modules.push_back(&*Outlines);
  }
  // Contours come after all lines, so that none is drawn over them.
  if (Certifier)
  {
    pipeline.modules.push_back(&*Certifier);
  }
  if (lines_ && drawn.contours)
  {
    pipeline.modules.push_back(&*lines_);
  }
  // The surfaces, with their lines, are inside the volume.
  if (volume_)
  {
    pipeline.modules.push_back(volume_.get());
  }
  return pipeline;
}

Buffer NeedsOf(const View& view, bool afterwards)
{
  const Appearance& appearance = view.appearance;
  // Labels need normals to detect where a surface hides a part of itself.
  const Buffer ofLabels =
    HasLabels(view) ? Buffer::Value | Buffer::Position | Buffer::Normal : Buffer::None;
  const Buffer ofContours = afterwards && appearance.HasContours()
    ? ContourCertifier({}, appearance.contours.method).Needs().welcome | Buffer::Layer
    : Buffer::None;
  return Buffer::Verdict | NeedsOfRules(view) | ofContours | ofLabels |
    (appearance.IsByValue() ? Buffer::Value : Buffer::None) |
    (MarksUndecided(appearance) ? Buffer::Enclosure : Buffer::None) |
    (view.scene.layers.size() > 1 ? Buffer::Layer : Buffer::None) |
    (appearance.IsLit() ? Buffer::Position | Buffer::Normal : Buffer::None) |
    (appearance.edges ? ElementEdges(*appearance.edges).Needs().centres : Buffer::None) |
    (appearance.outlines ? ElementOutlines().Needs().centres : Buffer::None) |
    (view.volume ? Buffer::Depth | Buffer::Volume : Buffer::None);
}
} // namespace pixelexact
