// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/AffineMap.h"
#include "Trace/Surfaces/ConvexKernels.h"
#include "Trace/Surfaces/Surface.h"

#include <vector>

namespace pixelexact
{
/// All x with normal . (x - point) <= 0.
struct HalfSpace
{
  Vec3 point;
  Vec3 normal;
};

/// The boundary of what half-spaces have in common, which may be without end, flat or empty; as
/// vtkPlanes and vtkBox. A ray meets it where it enters and where it leaves, at most; once where
/// these are the same. One that lies in a face meets it at the face's ends.
///
/// t is that of the given numbers but for the rounding of a face's normal and of sums of three
/// products. Hits tell the number of their face (HitSlots::Pieces).
class ConvexBody final : public Surface
{
public:
  /// The normals need not be of unit length. Throws Error when there is no half-space, a normal is
  /// zero, a number is not finite, or the map has no inverse; `what` names the surface in its
  /// message.
  explicit ConvexBody(const std::vector<HalfSpace>& halfSpaces, const AffineMap& toFunction = {},
    const char* what = "convex body");

  [[nodiscard]] const std::vector<ConvexFace>& PlanesOfFaces() const { return Faces; }

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  /// That of the point's face, or, where that is not known, of the one that is closest; outwards.
  [[nodiscard]] Vec3 Normal(const SurfacePoint& point) const override;

  [[nodiscard]] double Sagitta(
    const Ray& a, const SurfacePoint& atA, const Ray& b, const SurfacePoint& atB) const override;
  [[nodiscard]] bool HasSagitta() const override { return true; }
  [[nodiscard]] double Reach(const Chord& chord) const override;
  [[nodiscard]] bool IsClearOf(const Vec3& centre, double radius) const override;
  [[nodiscard]] std::vector<SurfacePatch> Implicit() const override;

private:
  std::vector<ConvexFace> Faces;
};

/// Throws Error when a coordinate of `lower` is above that of `upper`, a number is not finite, or
/// the map has no inverse.
ConvexBody MakeBox(const Vec3& lower, const Vec3& upper, const AffineMap& toFunction = {});
} // namespace pixelexact
