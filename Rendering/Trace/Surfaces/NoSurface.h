// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

namespace pixelexact
{
/// A surface without points, for scenes that show a volume alone.
class NoSurface final : public Surface
{
public:
  void Meet(const RayLanes& /*rays*/, HitSlots& /*hits*/) const override {}
  [[nodiscard]] Vec3 Normal(const SurfacePoint& /*point*/) const override { return Vec3(0.0); }
  [[nodiscard]] bool IsOfMesh() const override { return true; }
};
} // namespace pixelexact
