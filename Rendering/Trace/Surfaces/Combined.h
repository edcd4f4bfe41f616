// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Surface.h"

#include <functional>
#include <memory>
#include <vector>

namespace pixelexact
{
/// The boundary of a union, intersection or difference of bodies: along a ray, the points where the
/// combined inside test changes. All parts' hits divide the ray into intervals; the parts'
/// functions at the middle of each give its side. A hit is missing or superfluous only if hits of
/// two parts are so close that rounding decides what lies between them; the ray always ends on the
/// side that the body has there. Where parts only touch, or a ray touches a part, the test does not
/// change, and there is no hit.
class Combined final : public Surface
{
public:
  /// Negative inside. Called from several threads at once.
  using Side = std::function<double(const Vec3& x)>;

  /// A surface in closed form; of its hits, piece and position are kept.
  struct Part
  {
    std::shared_ptr<const Surface> surface;
    Side side; ///< its zeros are the surface
  };
  /// Combines the parts' inside flags, in the order of the parts.
  using Rule = std::function<bool(const std::vector<bool>& inside)>;

  /// Throws Error without parts.
  Combined(std::vector<Part> parts, Rule rule);

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  /// The normal of the hit's part.
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] bool HasSagitta() const override;
  /// True if MayMeet is true for one of the parts.
  [[nodiscard]] bool MayMeet(const Outline& part, double slack, EdgeWork* work) const override;

private:
  /// Largest distance from a chord at which its rays meet the whole, each once.
  [[nodiscard]] double ReachOfParts(const Chord& chord) const;
  /// The inside flag of the whole changes exactly once along rays that cross each of these parts
  /// once, in any order, between `middle` - `step` and `middle` + `step`. No other part is near.
  [[nodiscard]] bool ChangesOnce(
    const std::vector<bool>& isNear, const Vec3& middle, const Vec3& step) const;

  std::vector<Part> Parts;
  Rule IsInside;
};
} // namespace pixelexact
