// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameRequest.h"

#include "HighOrderModel.h"
#include "Trace/Surfaces/Plane.h"
#include "Views/VtkColorMap.h"

#include "vtkScalarsToColors.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pixelexact
{
vtkScalarsToColors* TableOf(const LayerRequest& layer)
{
  // By their colours, or by their values where these follow from the table's range.
  const ContourRule& contours = layer.appearance.contours;
  const bool byTable = contours.count > 0 || (contours.Any() && contours.colors.empty());
  return layer.table == nullptr && byTable ? layer.contourTable : layer.table;
}

const Field* FieldOf(const LayerRequest& layer, const HighOrderModel& model)
{
  const bool none = layer.table == nullptr && layer.field == FieldChoice{};
  return none && model.Fields().empty() ? nullptr : &layer.field.In(model);
}

int ComponentOf(const LayerRequest& layer, const Field& field)
{
  const bool solid = layer.table == nullptr && layer.appearance.contours.Any();
  const int component = layer.component.value_or(
    ComponentOf(solid ? layer.contourTable : layer.table, field.values.components));
  RequireComponent(field, component);
  // A scalar has no other.
  return component == kMagnitude && field.values.components == 1 ? 0 : component;
}

TraceKey TraceKeyOf(const FrameRequest& request)
{
  TraceKey key{ {}, request.kept, request.camera, request.stride };
  for (const LayerRequest& layer : request.layers)
  {
    const Field* const field = FieldOf(layer, *request.model);
    const int component = field != nullptr ? ComponentOf(layer, *field) : 0;
    if (layer.table != nullptr)
    {
      // Before that it does not know whether its colours are opaque.
      layer.table->Build();
    }
    // Nothing is behind a plane that is alone.
    const bool alone =
      request.layers.size() == 1 && dynamic_cast<const Plane*>(layer.surface.get()) != nullptr;
    const bool seenThrough = !alone &&
      (request.translucent || layer.appearance.opacity < 1.0 ||
        (layer.table != nullptr && layer.table->IsOpaque() == 0));
    key.layers.push_back({ layer.surface, layer.field, component, layer.precision, seenThrough });
  }
  return key;
}

Appearance AppearanceOf(const FrameRequest& request, const Scene& scene)
{
  Appearance appearance = request.appearance;
  appearance.layers.clear();
  std::vector<vtkScalarsToColors*> tables;
  for (std::size_t k = 0; k < request.layers.size(); ++k)
  {
    const LayerRequest& layer = request.layers[k];
    vtkScalarsToColors* const table = TableOf(layer);
    LayerAppearance own = layer.appearance;
    own.table = table != nullptr ? ColorTableOf(table) : nullptr;
    // One table has one range.
    tables.push_back(table);
    own.rangeGroup = static_cast<std::size_t>(std::ranges::find(tables, table) - tables.begin());
    if (layer.table != nullptr)
    {
      own.solid.reset();
    }
    if (!layer.litWhereFlat && scene.layers[k].surface->IsFlat())
    {
      own.material.reset();
    }
    appearance.layers.push_back(std::move(own));
  }
  if (!appearance.IsLit())
  {
    appearance.lights.clear();
    appearance.lit = {};
  }
  if (!appearance.HasContours())
  {
    appearance.contours = {};
  }
  appearance.faces = appearance.edges && request.edgesByKind ? &request.model->Faces() : nullptr;
  return appearance;
}
} // namespace pixelexact
