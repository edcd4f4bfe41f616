// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameKeys.h"

#include "HighOrderModel.h"
#include "Trace/Surfaces/Plane.h"

#include "vtkScalarsToColors.h"

#include <algorithm>

namespace pixelexact
{
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
      (request.translucent || layer.opacity < 1.0 ||
        (layer.table != nullptr && layer.table->IsOpaque() == 0));
    key.layers.push_back({ layer.surface, layer.field, component, layer.precision, seenThrough });
  }
  return key;
}

ColorKey ColorKeyOf(const FrameRequest& request, const Scene& scene)
{
  ColorKey key;
  key.unknown = request.unknownColor;
  bool anyLit = false;
  for (std::size_t k = 0; k < request.layers.size(); ++k)
  {
    const LayerRequest& layer = request.layers[k];
    const bool lit = layer.material && (layer.litWhereFlat || !scene.layers[k].surface->IsFlat());
    anyLit = anyLit || lit;
    vtkScalarsToColors* const table = TableOf(layer);
    std::uint64_t state = 0;
    if (table != nullptr)
    {
      state = table->GetMTime();
    }
    key.layers.push_back({ table, state, layer.table == nullptr, layer.solidColor, layer.opacity,
      lit ? layer.material : std::nullopt, layer.contours });
  }
  if (anyLit)
  {
    key.lights = request.lights;
    key.lit = request.lit;
  }
  key.edges = request.edges;
  if (std::ranges::any_of(
        request.layers, [](const LayerRequest& layer) { return layer.contours.Any(); }))
  {
    key.contours = request.contours;
  }
  return key;
}
} // namespace pixelexact
