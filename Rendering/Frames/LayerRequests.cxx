// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/LayerRequests.h"

#include "Views/VtkLook.h"
#include "vtkHighOrderLayer.h"
#include "vtkHighOrderMapper.h"

#include "vtkScalarsToColors.h"

namespace pixelexact
{
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
    // The mapper's is of its own field.
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
    // The actor's colour is not the layer's.
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
  // Before that it does not know.
  table->Build();
  return table->IsOpaque() != 0;
}
} // namespace pixelexact
