// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

#include <functional>
#include <memory>
#include <vector>

namespace pixelexact
{
/// The points of surfaces where no clip is positive. A hit's clip is evaluated at the hit's rounded
/// position, so hits within rounding of a clip's zeros may be on either side.
///
/// One part may be any surface; its hits keep their data. Several parts must be surfaces in closed
/// form; of their hits, piece and position are kept. Where parts meet, the first one's hit comes
/// first.
class Clipped final : public Surface
{
public:
  /// Called from several threads at once.
  using Side = std::function<double(const Vec3& x)>;

  /// Throws Error without parts.
  Clipped(std::vector<std::shared_ptr<const Surface>> parts, std::vector<Side> clips);

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;
  void Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const override;
  [[nodiscard]] bool HasCostlyNormals() const override;
  [[nodiscard]] bool NeedsCallingThread() const override;
  [[nodiscard]] bool IsFlat() const override;
  [[nodiscard]] bool MayMeet(const Outline& part, double slack, EdgeWork* work) const override;
  [[nodiscard]] std::optional<double> HeldValue(const Field& field, int component) const override;
  [[nodiscard]] bool IsOfMesh() const override;
  [[nodiscard]] int FaceOf(std::int32_t piece) const override;

  // Between two hits a clip may remove the surface, so no Sagitta is proven.
  [[nodiscard]] bool HasSagitta() const override { return false; }

private:
  [[nodiscard]] bool IsKept(const Vec3& x) const;
  [[nodiscard]] bool IsSingle() const { return Parts.size() == 1; }

  std::vector<std::shared_ptr<const Surface>> Parts;
  std::vector<Side> Clips;
};
} // namespace pixelexact
