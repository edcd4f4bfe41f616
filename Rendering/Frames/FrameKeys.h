// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/FrameRequest.h"
#include "Trace/Scene.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pixelexact
{
struct TracedLayer
{
  // Kept alive, so that no other surface can have its address.
  std::shared_ptr<const Surface> surface;
  FieldChoice field;
  int component = 0;
  Precision precision = Precision::Double;
  bool translucent = false;

  bool operator==(const TracedLayer&) const = default;
};
struct TraceKey
{
  std::vector<TracedLayer> layers;
  std::vector<KeptHalfSpace> kept;
  CameraSetup camera;
  int stride = 1;

  bool operator==(const TraceKey&) const = default;
};
/// Of a request with a model. Throws Error where that lacks a field or a component.
[[nodiscard]] TraceKey TraceKeyOf(const FrameRequest& request);
} // namespace pixelexact
