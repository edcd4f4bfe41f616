// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/LayerRequests.h"

#include "HighOrderModel.h"
#include "Views/VtkColorMap.h"
#include "Views/VtkLook.h"
#include "vtkHighOrderLayer.h"
#include "vtkHighOrderMapper.h"

#include "vtkScalarsToColors.h"

#include <algorithm>
#include <utility>

namespace pixelexact
{
namespace
{
/// Null if the model has no fields and the layer requests none.
const Field* FieldOf(const LayerRequest& layer, const HighOrderModel& model)
{
  const bool none = layer.table == nullptr && layer.field == FieldChoice{};
  return none && model.Fields().empty() ? nullptr : &layer.field.In(model);
}

/// The component of the field that the layer shows: its own, or else the table's.
int ComponentOf(const LayerRequest& layer, const Field& field)
{
  const bool solid = layer.table == nullptr && layer.appearance.contours.Any();
  const int component = layer.component.value_or(
    pixelexact::ComponentOf(solid ? layer.contourTable : layer.table, field.values.components));
  RequireComponent(field, component);
  // A scalar field has only component 0.
  return component == kMagnitude && field.values.components == 1 ? 0 : component;
}

/// The first layer with the same table, because one table has one range.
std::size_t RangeGroupOf(const LayerAppearance& layer, const std::vector<LayerAppearance>& before)
{
  const auto isSame = [&layer](const LayerAppearance& other)
  {
    return layer.table == nullptr ? other.table == nullptr
                                  : other.table != nullptr && layer.table->IsSame(*other.table);
  };
  return static_cast<std::size_t>(std::ranges::find_if(before, isSame) - before.begin());
}
} // namespace

vtkScalarsToColors* TableOf(const LayerRequest& layer)
{
  // Contours use the table for their colours, or for values that depend on its range.
  const ContourRule& contours = layer.appearance.contours;
  const bool byTable = contours.count > 0 || (contours.Any() && contours.colors.empty());
  return layer.table == nullptr && byTable ? layer.contourTable : layer.table;
}

void AddLayer(const LayerRequest& layer, const HighOrderModel& model, View& view)
{
  const Field* const field = FieldOf(layer, model);
  view.scene.layers.push_back(
    { layer.surface, field, field != nullptr ? ComponentOf(layer, *field) : 0, layer.precision });
  LayerAppearance appearance = layer.appearance;
  vtkScalarsToColors* const table = TableOf(layer);
  appearance.table = table != nullptr ? ColorTableOf(table) : nullptr;
  appearance.rangeGroup = RangeGroupOf(appearance, view.appearance.layers);
  if (layer.table != nullptr)
  {
    appearance.solid.reset();
  }
  if (!layer.litWhereFlat && layer.surface->IsFlat())
  {
    appearance.material.reset();
  }
  view.appearance.layers.push_back(std::move(appearance));
}

LayerRequest LayerOf(vtkHighOrderMapper* mapper, vtkProperty* property)
{
  LayerRequest layer;
  const char* field = mapper->GetFieldName();
  layer.field =
    field == nullptr || field[0] == '\0' ? FieldOf(mapper) : FieldChoice{ .name = field };
  layer.appearance.solid = ColorOf(property);
  layer.appearance.material = MaterialOf(property, !mapper->GetScalarVisibility());
  layer.litWhereFlat = mapper->GetLightFlat();
  if (mapper->GetScalarVisibility())
  {
    layer.table = mapper->GetLookupTable();
  }
  layer.contourTable = mapper->GetLookupTable();
  if (mapper->GetComponent() != vtkHighOrderLayer::BY_LOOKUP_TABLE)
  {
    layer.component = mapper->GetComponent();
  }
  else if (mapper->GetArrayComponent() >= 0)
  {
    layer.component = mapper->GetArrayComponent();
  }
  return layer;
}

LayerRequest LayerOf(vtkHighOrderLayer* layer, LayerRequest ofAll)
{
  LayerRequest request = std::move(ofAll);
  const char* field = layer->GetFieldName();
  if (field != nullptr && field[0] != '\0')
  {
    request.field = { .name = field };
    // The mapper's component belongs to its own field.
    request.component.reset();
  }
  if (layer->GetComponent() != vtkHighOrderLayer::BY_LOOKUP_TABLE)
  {
    request.component = layer->GetComponent();
  }
  if (layer->GetLookupTable() != nullptr)
  {
    request.table = layer->GetLookupTable();
    request.contourTable = layer->GetLookupTable();
  }
  if (!layer->GetScalarVisibility())
  {
    request.table = nullptr;
    request.appearance.solid = ToRgba(layer->GetColor());
  }
  if (!layer->GetContourVisibility())
  {
    request.appearance.contours = {};
  }
  else if (layer->GetContourCount() > 0)
  {
    request.appearance.contours.count = layer->GetContourCount();
    request.appearance.contours.values.clear();
  }
  else if (layer->GetNumberOfContours() > 0)
  {
    request.appearance.contours.count = 0;
    request.appearance.contours.values.clear();
    for (int i = 0; i < layer->GetNumberOfContours(); ++i)
    {
      request.appearance.contours.values.push_back(layer->GetContourValue(i));
    }
  }
  request.appearance.opacity = layer->GetOpacity();
  request.precision = layer->GetSinglePrecision() ? Precision::Float : Precision::Double;
  request.litWhereFlat = layer->GetLightFlat();
  if (!layer->GetLighting())
  {
    request.appearance.material.reset();
  }
  else if (request.appearance.material)
  {
    // The actor's colour does not apply to the layer.
    request.appearance.material->ambientColor.reset();
  }
  return request;
}

bool IsOpaque(vtkMapper* mapper, vtkHighOrderLayer* layer)
{
  vtkScalarsToColors* table = mapper->GetScalarVisibility() ? mapper->GetLookupTable() : nullptr;
  if (layer != nullptr)
  {
    if (layer->GetOpacity() < 1.0)
    {
      return false;
    }
    table = layer->GetLookupTable() != nullptr ? layer->GetLookupTable() : table;
    table = layer->GetScalarVisibility() ? table : nullptr;
  }
  if (table == nullptr)
  {
    return true;
  }
  // IsOpaque is undefined before Build.
  table->Build();
  return table->IsOpaque() != 0;
}
} // namespace pixelexact
