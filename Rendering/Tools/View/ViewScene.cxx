// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewScene.h"

#include "Picture/DrawnShot.h"

#include <vtkActor.h>
#include <vtkHighOrderLayer.h>
#include <vtkHighOrderMapper.h>
#include <vtkLookupTable.h>
#include <vtkObjectFactory.h>
#include <vtkPlane.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <vector>

namespace pixelexact
{
vtkStandardNewMacro(GivenSurfaceOfLayer);

ViewScene::ViewScene(const RenderOptions& options)
  : Options(options)
{
  TheActor->SetMapper(TheMapper);
}

ViewScene::~ViewScene() = default;

vtkActor& ViewScene::Actor() const
{
  return *TheActor;
}

vtkHighOrderMapper& ViewScene::Mapper() const
{
  return *TheMapper;
}

vtkLookupTable* ViewScene::FirstTable() const
{
  return Tables.front();
}

void ViewScene::MoveFirst(const std::shared_ptr<const Surface>& surface)
{
  First->Set(surface);
}

void ViewScene::MakeTables(const Shot& shot)
{
  // Of what the view shows, as render's.
  Shot seen = shot;
  const Frame frame = TraceShot(Options, seen, {});
  const ShotAppearance appearance(Options.shot.colors, nullptr, seen, frame);
  TheRanges = appearance.Ranges();
  Tables.clear();
  for (std::size_t k = 0; k < TheRanges.size(); ++k)
  {
    Tables.push_back(TheRanges[k]
        ? Options.shot.colors.TableOver(*TheRanges[k], shot.settings[k].colormap)
        : nullptr);
  }
  Solids.clear();
  for (const ColorMap& map : appearance.Maps())
  {
    const double any = 0.0;
    Rgba color{};
    map({ &any, 1 }, color.data());
    Solids.push_back({ color[0] / 255.0, color[1] / 255.0, color[2] / 255.0 });
  }
}

void ViewScene::MakeLayers(const Shot& shot)
{
  TheMapper->SetInputData(shot.input.grid);
  TheMapper->RemoveAllLayers();
  const std::vector<Layer>& layers = shot.scene.layers;
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    const LayerSettings& settings = shot.settings[k];
    vtkNew<vtkHighOrderLayer> layer;
    vtkNew<GivenSurfaceOfLayer> own;
    GivenSurfaceOfLayer* surface = k == 0 ? First.Get() : own.Get();
    surface->Set(layers[k].surface);
    layer->SetSurface(surface);
    if (layers[k].field != nullptr)
    {
      layer->SetFieldName(layers[k].field->name.c_str());
      layer->SetComponent(layers[k].component);
    }
    layer->SetScalarVisibility(Tables[k] != nullptr);
    layer->SetLookupTable(Tables[k]);
    layer->SetColor(Solids[k].data());
    layer->SetOpacity(settings.opacity);
    const bool lit = settings.lights.value_or(shot.lights != Lit::Off);
    layer->SetLighting(lit);
    layer->SetLightFlat(lit && (settings.lights || shot.lights == Lit::On));
    TheMapper->AddLayer(layer);
  }
  TheMapper->SetUseLookupTableScalarRange(true);
  TheMapper->SetSamples(shot.samples);
  TheMapper->SetEdgesByKind(shot.edgesByKind);
  TheMapper->SetOutlines(shot.outlines.has_value());
  if (shot.outlines)
  {
    TheMapper->SetOutlineColor(shot.outlines->data());
  }
  TheMapper->RemoveAllClippingPlanes();
  for (const std::vector<double>& p : Options.shot.clip)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(p[0], p[1], p[2]);
    plane->SetNormal(p[3], p[4], p[5]);
    TheMapper->AddClippingPlane(plane);
  }
}

void ViewScene::ShowContours(bool on)
{
  const auto first =
    std::ranges::find_if(TheRanges, [](const auto& range) { return range.has_value(); });
  TheMapper->SetNumberOfContours(0);
  TheMapper->SetContourCount(0);
  if (!on || first == TheRanges.end())
  {
    return;
  }
  const ContourRule choice =
    Options.contours.AreGiven() ? Options.contours.OfAll() : ContourRule{ .count = kUsualContours };
  TheMapper->SetContourCount(choice.count);
  for (std::size_t i = 0; i < choice.values.size(); ++i)
  {
    TheMapper->SetContourValue(static_cast<int>(i), choice.values[i]);
  }
  TheMapper->SetContourWidth(Options.contours.Style().width);
}
} // namespace pixelexact
