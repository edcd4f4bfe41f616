// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Base/MadeOnDemand.h"
#include "Core/Index/EmbreeBvh.h"
#include "Trace/Surfaces/Curved/BundleHierarchy.h"
#include "Trace/Surfaces/Surface.h"

#include <array>
#include <vector>

namespace pixelexact
{
/// A surface of triangles, as they are: no normals are made up between their corners. Either side
/// counts. Where triangles share an edge or a corner, with the same coordinates to the bit, no ray
/// slips through between them, and one that meets what they share meets it once.
///
/// A ray is seen to meet a triangle where, in the plane across the ray, the origin lies in it or on
/// its edge, with the corners' places in that plane rounded once; so near an edge the other
/// triangle may be met, or none beyond the surface's rim, within 4 roundings of the corners'
/// distance from the ray's origin. Rays in a triangle's plane miss it. t is off as a
/// Plane's is, and by some roundings times the square of the longest edge over the height on it and
/// the slope.
class Triangles final : public Surface
{
public:
  using Triangle = std::array<Vec3, 3>;

  /// Triangles without area are met by no ray. Throws Error without triangles, for corners that are
  /// not finite (naming the first). Hierarchies are made when rays first ask, and throw where
  /// Embree fails.
  explicit Triangles(std::vector<Triangle> triangles);
  ~Triangles() override;
  Triangles(const Triangles&) = delete;
  Triangles& operator=(const Triangles&) = delete;

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] bool HasSagitta() const override { return true; }
  [[nodiscard]] std::vector<SurfacePatch> Implicit() const override;

  [[nodiscard]] const std::vector<Triangle>& Corners() const { return All; }
  [[nodiscard]] const Box3& Bounds() const { return bounds_; }

private:
  struct Beam;
  [[nodiscard]] std::vector<Box3> Boxes() const;
  /// For neighbouring rays together, made when some first ask.
  [[nodiscard]] const BundleHierarchy& ForBeams() const;
  /// For single rays and points, made when one first asks. Throws Error where Embree fails.
  [[nodiscard]] const Bvh& ForRays() const;
  /// Of `count` rays from number `first` on.
  void MeetBeam(const RayLanes& rays, int first, int count, Beam& beam, HitSlots& hits) const;
  /// The triangle on the other side of an edge, or of several the wanted one; -1 where there is
  /// none, or no telling which.
  [[nodiscard]] std::int32_t Beyond(
    std::int32_t triangle, const Vec3& p, const Vec3& q, std::int32_t wanted) const;
  /// How far off a triangle's plane its hits may be, beside the rounding of positions.
  [[nodiscard]] double SlackOf(std::int32_t triangle) const;

  std::vector<Triangle> All;
  std::vector<Vec3> NormalOfEach;
  Box3 bounds_;
  MadeOnDemand<BundleHierarchy> Together{ 1 };
  MadeOnDemand<Bvh> Single{ 1 };
  double Extent = 0.0; ///< of a triangle, the mean
};
} // namespace pixelexact
