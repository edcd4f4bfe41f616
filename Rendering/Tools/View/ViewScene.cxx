// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewScene.h"

#include "Picture/DrawnShot.h"

#include "Trace/View.h"

#include <vtkActor.h>
#include <vtkHighOrderLayer.h>
#include <vtkHighOrderMapper.h>
#include <vtkLookupTable.h>
#include <vtkObjectFactory.h>
#include <vtkPlane.h>
#include <vtkUnstructuredGrid.h>

#include <memory>
#include <vector>

namespace pixelexact
{
vtkStandardNewMacro(GivenSurfaceOfLayer);

ViewScene::ViewScene(const RenderOptions& options)
  : Options(options)
{
  Drawn->SetMapper(DrawnBy);
}

ViewScene::~ViewScene() = default;

vtkActor& ViewScene::Actor() const
{
  return *Drawn;
}

vtkHighOrderMapper& ViewScene::Mapper() const
{
  return *DrawnBy;
}

vtkSmartPointer<vtkLookupTable> ViewScene::FirstTable(const Shot& shot) const
{
  const auto& range = FoundRanges.front();
  return range ? Options.shot.colors.TableOver(*range, shot.settings.front().colormap) : nullptr;
}

void ViewScene::MoveFirst(const std::shared_ptr<const Surface>& surface)
{
  First->Set(surface);
}

void ViewScene::FindRanges(const Shot& shot)
{
  const Frame frame = TraceShot(Options, shot, {});
  FoundRanges = ShotAppearance(Options.shot.colors, nullptr, shot, frame).Ranges();
}

void ViewScene::Show(const Shot& shot, bool contours, bool edges)
{
  DrawnBy->SetInputData(shot.input.grid);
  DrawnBy->RemoveAllLayers();
  View view = ViewOf(Options.shot.colors, contours ? &Options.contours : nullptr, shot);
  for (std::size_t k = 0; k < view.scene.layers.size(); ++k)
  {
    const Layer& from = view.scene.layers[k];
    vtkNew<vtkHighOrderLayer> layer;
    vtkNew<GivenSurfaceOfLayer> own;
    GivenSurfaceOfLayer* surface = k == 0 ? First.Get() : own.Get();
    surface->Set(from.surface);
    layer->SetSurface(surface);
    if (from.field != nullptr)
    {
      layer->SetFieldName(from.field->name.c_str());
      layer->SetComponent(from.component);
    }
    layer->SetScalarVisibility(from.field != nullptr);
    layer->SetSinglePrecision(from.precision == Precision::Float);
    layer->SetOpacity(view.appearance.layers[k].opacity); // it is drawn with what is translucent
    DrawnBy->AddLayer(layer);
    LayerAppearance& drawn = view.appearance.layers[k];
    if (FoundRanges[k])
    {
      drawn.range = { RangeRule::Of::Ends, *FoundRanges[k] };
    }
    if (contours && !Options.contours.AreGiven() && from.field != nullptr)
    {
      drawn.contours = { .count = kDefaultContours, .colors = { Rgba{ 0, 0, 0, 255 } } };
    }
  }
  if (!edges)
  {
    view.appearance.edges.reset();
  }
  else if (!view.appearance.edges)
  {
    view.appearance.edges.emplace();
  }
  DrawnBy->SetAppearance(std::make_shared<const Appearance>(view.appearance));
  DrawnBy->RemoveAllClippingPlanes();
  for (const std::vector<double>& p : Options.shot.clip)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(p[0], p[1], p[2]);
    plane->SetNormal(p[3], p[4], p[5]);
    DrawnBy->AddClippingPlane(plane);
  }
}
} // namespace pixelexact
