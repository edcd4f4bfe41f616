// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameRequest.h"

#include "HighOrderModel.h"
#include "Views/VtkColorMap.h"

namespace pixelexact
{
vtkScalarsToColors* TableOf(const LayerRequest& layer)
{
  // By their colours, or by their values where these follow from the table's range.
  const bool byTable =
    layer.contours.count > 0 || (layer.contours.Any() && layer.contours.colors.empty());
  return layer.table == nullptr && byTable ? layer.contourTable : layer.table;
}

const Field* FieldOf(const LayerRequest& layer, const HighOrderModel& model)
{
  const bool none = layer.table == nullptr && layer.field == FieldChoice{};
  return none && model.Fields().empty() ? nullptr : &layer.field.In(model);
}

int ComponentOf(const LayerRequest& layer, const Field& field)
{
  const bool solid = layer.table == nullptr && layer.contours.Any();
  const int component = layer.component.value_or(
    ComponentOf(solid ? layer.contourTable : layer.table, field.values.components));
  RequireComponent(field, component);
  // A scalar has no other.
  return component == kMagnitude && field.values.components == 1 ? 0 : component;
}
} // namespace pixelexact
