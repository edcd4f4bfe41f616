// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surface.h"

namespace pixelexact
{
/// All x with (x - origin) . normal = 0. A ray that lies in the plane does not meet it.
class Plane final : public Surface
{
public:
  /// Throws Error when the normal is zero or a number is not finite. The normal need not be of
  /// unit length.
  Plane(const Vec3& origin, const Vec3& normal);

  void NextHit(const RayLanes& rays, const double* tMin, const HitLanes& hits) const override;
  [[nodiscard]] int MostHits() const override { return 1; }
  [[nodiscard]] Vec3 Normal(const Vec3& position) const override;

private:
  Vec3 Origin;
  Vec3 UnitNormal;
};
} // namespace pixelexact
