// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surface.h"

#include <array>
#include <memory>
#include <vector>

namespace pixelexact
{
/// The points (x, y, z) with a x + b y + c z + d >= 0.
using KeptHalfSpace = std::array<double, 4>;

/// The part of a surface that lies in all of the half-spaces: a ray goes on through the rest to
/// what is behind. For a mapper's clipping planes and a camera's near plane.
class ClippedSurface final : public Surface
{
public:
  ClippedSurface(std::shared_ptr<const Surface> whole, std::vector<KeptHalfSpace> kept);

  void NextHit(const RayLanes& rays, const double* tMin, const HitLanes& hits) const override;
  [[nodiscard]] int MostHits() const override { return Whole->MostHits(); }
  [[nodiscard]] Vec3 Normal(const Vec3& position) const override;

private:
  [[nodiscard]] bool Keeps(const Vec3& position) const;

  std::shared_ptr<const Surface> Whole;
  std::vector<KeptHalfSpace> Kept;
};
} // namespace pixelexact
