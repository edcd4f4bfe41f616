// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

#include <functional>
#include <memory>
#include <vector>

namespace pixelexact
{
/// The boundary of a body that is made of others by union, intersection and difference: where,
/// along a ray, the sign of the whole changes. All hits of all parts cut the ray into pieces; in
/// the middle of each the parts' functions say on which side it is. So a hit is missing, or too
/// many, only where two parts' hits are so close that rounding decides what lies between them, and
/// never does the ray come out on another side than the body has there. Where parts only touch, and
/// where a ray touches a part, nothing changes, and there is no hit.
class Combined final : public Surface
{
public:
  /// Below 0 inside. Called from several threads at once.
  using Side = std::function<double(const Vec3& x)>;

  /// A surface in closed form: of what its hits tell, piece and position count here.
  struct Part
  {
    std::shared_ptr<const Surface> surface;
    Side side; ///< whose zeros are the surface
  };
  /// Whether the whole is inside where the parts are; they come in the order they were given in.
  using Rule = std::function<bool(const std::vector<bool>& inside)>;

  /// Throws Error without parts.
  Combined(std::vector<Part> parts, Rule rule);

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  /// That of the part.
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] bool HasSagitta() const override;
  /// Where one of the parts' may be.
  [[nodiscard]] bool MayMeet(const Outline& part, double slack, EdgeWork* work) const override;

private:
  /// How far from a chord at most its rays meet the whole, each once within that.
  [[nodiscard]] double ReachOfParts(const Chord& chord) const;
  /// Whether the whole changes exactly once along rays that cross these parts, each once, in any
  /// order, between `middle` - `step` and `middle` + `step`; all others are nowhere near.
  [[nodiscard]] bool ChangesOnce(
    const std::vector<bool>& isNear, const Vec3& middle, const Vec3& step) const;

  std::vector<Part> Parts;
  Rule IsInside;
};
} // namespace pixelexact
