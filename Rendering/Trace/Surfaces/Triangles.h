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
/// A surface of flat triangles; normals are not interpolated between corners. Both sides count. If
/// triangles share an edge or a corner, with coordinates equal to the bit, no ray passes between
/// them, and a ray that meets the shared edge or corner meets it once.
///
/// A ray meets a triangle if, in the plane across the ray, the origin lies in the triangle or on
/// its edge, after the corners' coordinates in that plane have been rounded once. So within 4
/// roundings of the corners' distance from the ray's origin, the hit may be with the neighbouring
/// triangle, or missing beside the surface's rim. Rays in a triangle's plane miss it. t's error is
/// that of a Plane, plus some roundings times the square of the longest edge over its height and
/// the slope.
class Triangles final : public Surface
{
public:
  using Triangle = std::array<Vec3, 3>;

  /// No ray meets triangles without area. Throws Error without triangles, and for corners that are
  /// not finite (naming the first). Hierarchies are built on first use, which throws if Embree
  /// fails.
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
  /// Hierarchy for beams of neighbouring rays, built on first use.
  [[nodiscard]] const BundleHierarchy& ForBeams() const;
  /// Hierarchy for single rays and points, built on first use. Throws Error if Embree fails.
  [[nodiscard]] const Bvh& ForRays() const;
  /// Meets `count` rays from number `first` on.
  void MeetBeam(const RayLanes& rays, int first, int count, Beam& beam, HitSlots& hits) const;
  /// The triangle on the other side of edge pq; of several, `wanted`. -1 if there is none, or if it
  /// is ambiguous.
  [[nodiscard]] std::int32_t Beyond(
    std::int32_t triangle, const Vec3& p, const Vec3& q, std::int32_t wanted) const;
  /// Largest distance of a triangle's hits from its plane, in addition to the rounding of
  /// positions.
  [[nodiscard]] double SlackOf(std::int32_t triangle) const;

  std::vector<Triangle> All;
  std::vector<Vec3> NormalOfEach;
  Box3 bounds_;
  MadeOnDemand<BundleHierarchy> Together{ 1 };
  MadeOnDemand<Bvh> Single{ 1 };
  double Extent = 0.0; ///< mean extent of a triangle
};
} // namespace pixelexact
