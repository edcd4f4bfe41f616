// SPDX-License-Identifier: BSD-3-Clause
#include "View/ViewScene.h"

#include "Drawing/Canvas.h"
#include "Picture/DrawnShot.h"

#include "Trace/View.h"

#include <vtkActor.h>
#include <vtkHighOrderLayer.h>
#include <vtkHighOrderMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOutlineSource.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
/// Side of the traced picture where no range depends on it.
constexpr int kSmallSide = 16;
} // namespace

vtkStandardNewMacro(GivenSurfaceOfLayer);

ViewScene::ViewScene()
{
  Drawn->SetMapper(DrawnBy);
  Box->PickableOff();
  Box->GetProperty()->LightingOff();
}

ViewScene::~ViewScene() = default;

void ViewScene::MoveFirst(const std::shared_ptr<const Surface>& surface)
{
  First->Set(surface);
}

void ViewScene::FindRanges(const RenderOptions& options, const Shot& shot)
{
  Shot traced = shot;
  const View view = ViewOf(options.shot.colors, nullptr, shot);
  if (std::ranges::none_of(view.appearance.layers,
        [](const LayerAppearance& layer) { return layer.range.IsOfFrame(); }))
  {
    traced.size = { kSmallSide, kSmallSide, {} };
  }
  const Frame frame = TraceShot(options, traced, {});
  // The new colours refer to the new shot; the old ones must not outlive theirs.
  Colors.reset();
  Traced = std::move(traced);
  Colors = std::make_unique<ShotAppearance>(options.shot.colors, &options.contours, *Traced, frame);
}

void ViewScene::ShowOutline(const RenderOptions& options, const Shot& shot)
{
  const Box3 box = BoxOf(*shot.input.model);
  vtkNew<vtkOutlineSource> edges;
  edges->SetBounds(box.lower.x, box.upper.x, box.lower.y, box.upper.y, box.lower.z, box.upper.z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  Box->SetMapper(mapper);
  Box->SetVisibility(options.outline.IsAsked());
  const Rgba color = options.outline.LineColor();
  Box->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  Box->GetProperty()->SetLineWidth(static_cast<float>(options.outline.LineWidth()));
}

void ViewScene::Show(const RenderOptions& options, const Shot& shot)
{
  FindRanges(options, shot);
  ShowOutline(options, shot);
  DrawnBy->SetInputData(shot.input.grid);
  DrawnBy->RemoveAllLayers();
  View view = ViewOf(options.shot.colors, &options.contours, shot);
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
    if (const ValueRange& range = Ranges()[k])
    {
      drawn.range = { RangeRule::Of::Ends, *range };
    }
    // A number of contours would be resolved in each complete frame, which a drag then waits for.
    if (drawn.contours.count > 0)
    {
      drawn.contours.values = Colors->Resolved().layers[k].contours;
      drawn.contours.count = 0;
    }
  }
  DrawnBy->SetAppearance(std::make_shared<const Appearance>(view.appearance));
  DrawnBy->RemoveAllClippingPlanes();
  for (const std::vector<double>& p : options.shot.clip)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(p[0], p[1], p[2]);
    plane->SetNormal(p[3], p[4], p[5]);
    DrawnBy->AddClippingPlane(plane);
  }
}

Image ViewScene::Figure(const RenderOptions& options, const Shot& shot) const
{
  const FigureLayout& layout = *shot.layout;
  Rgba background = options.shot.colors.BackgroundColor();
  background[3] = 255;
  RasterCanvas canvas(
    layout.size.width, layout.size.height, background, layout.font, options.font.Choice());
  Frame frame;
  frame.width = shot.size.width;
  frame.height = shot.size.height;
  frame.counters.unknown = DrawnBy->GetNumberOfUnknownPixels();
  const bool hasBars =
    !options.contours.AreGiven() || !options.contours.Only() || options.contours.ByMap();
  options.figure.Draw(canvas, { shot, *Colors, frame, options.shot.colors, hasBars, {}, {}, {} });
  return canvas.Picture();
}
} // namespace pixelexact
