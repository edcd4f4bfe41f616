// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/AffineMap.h"
#include "Trace/Surfaces/Surface.h"
#include "Trace/Surfaces/SurfaceKernels.h"

#include <vector>

namespace pixelexact
{
/// All x with normal . (x - point) <= 0.
struct HalfSpace
{
  Vec3 point;
  Vec3 normal;
};

/// The boundary of an intersection of half-spaces, which may be infinite, flat or empty, as
/// vtkPlanes and vtkBox. A ray meets it at most where it enters and where it leaves; if these are
/// equal, once. A ray that lies in a face meets the boundary at the face's ends.
///
/// t's error is that of the rounding of a face's normal and of sums of three products. Hits store
/// the number of their face (HitSlots::Pieces).
class ConvexBody final : public Surface
{
public:
  /// The normals need not have unit length. Throws Error if there is no half-space, a normal is
  /// zero, a number is not finite, or the map has no inverse; `what` names the surface in the
  /// message.
  explicit ConvexBody(const std::vector<HalfSpace>& halfSpaces, const AffineMap& toFunction = {},
    const char* what = "convex body");

  [[nodiscard]] const std::vector<ConvexFace>& PlanesOfFaces() const { return Faces; }

  void Meet(const RayLanes& rays, HitSlots& hits) const override;
  /// The outward normal of the point's face or, if that is unknown, of the closest face.
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

/// Throws Error if a coordinate of `lower` is above that of `upper`, a number is not finite, or the
/// map has no inverse.
ConvexBody MakeBox(const Vec3& lower, const Vec3& upper, const AffineMap& toFunction = {});
} // namespace pixelexact
