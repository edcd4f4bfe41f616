// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameRequest.h"

#include "HighOrderModel.h"
#include "Views/VtkColorMap.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pixelexact
{
vtkScalarsToColors* TableOf(const LayerRequest& layer)
{
  // By their colours, or by their values where these follow from the table's range.
  const ContourRule& contours = layer.look.contours;
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
  const bool solid = layer.table == nullptr && layer.look.contours.Any();
  const int component = layer.component.value_or(
    ComponentOf(solid ? layer.contourTable : layer.table, field.values.components));
  RequireComponent(field, component);
  // A scalar has no other.
  return component == kMagnitude && field.values.components == 1 ? 0 : component;
}

ViewLook LookOf(const FrameRequest& request, const Scene& scene)
{
  ViewLook look = request.look;
  look.layers.clear();
  std::vector<vtkScalarsToColors*> tables;
  for (std::size_t k = 0; k < request.layers.size(); ++k)
  {
    const LayerRequest& layer = request.layers[k];
    vtkScalarsToColors* const table = TableOf(layer);
    LayerLook own = layer.look;
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
    look.layers.push_back(std::move(own));
  }
  if (!look.IsLit())
  {
    look.lights.clear();
    look.lit = {};
  }
  if (!look.HasContours())
  {
    look.contours = {};
  }
  look.faces = look.edges && request.edgesByKind ? &request.model->Faces() : nullptr;
  return look;
}
} // namespace pixelexact
