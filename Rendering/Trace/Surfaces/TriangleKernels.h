// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Curved/RayBundle.h"

#include <array>

namespace pixelexact
{
/// Intersections of a bundle's rays with one triangle, by ray.
struct TriangleLanes
{
  RayBundle::Numbers t;
  std::array<RayBundle::Numbers, 3> position;
  /// Barycentric weights of the second and third corner.
  std::array<RayBundle::Numbers, 2> weight;
  /// Rays for which a corner's weight is zero: they meet the opposite edge.
  std::array<RaySet, 3> across;
};

/// Kernels dispatched at run time to the instruction set. All of them give the same bits.
struct TriangleKernels
{
  /// Returns the rays among `some` that meet the triangle with this normal, on either side or on
  /// its edges, within their intervals.
  ///
  /// Corners are moved and sheared to each ray's coordinates, in which the ray is the third axis,
  /// one by one, so that triangles agree on shared edges (S. Woop, C. Benthin, I. Wald, Watertight
  /// Ray/Triangle Intersection, JCGT 2(1), 2013; there a ray's coordinates begin at its origin,
  /// here at the bundle's z0, next to the triangles). The bundle must have been constructed from
  /// `rays`.
  RaySet (*meet)(const RayBundle& bundle, const RayLanes& rays, const RaySet& some,
    const std::array<Vec3, 3>& triangle, const Vec3& normal, TriangleLanes& lanes);
};

const TriangleKernels& GetTriangleKernels();
} // namespace pixelexact
