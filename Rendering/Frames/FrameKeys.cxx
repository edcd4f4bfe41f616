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
      (request.translucent || layer.appearance.opacity < 1.0 ||
        (layer.table != nullptr && layer.table->IsOpaque() == 0));
    key.layers.push_back({ layer.surface, layer.field, component, layer.precision, seenThrough });
  }
  return key;
}
} // namespace pixelexact
