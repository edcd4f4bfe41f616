// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Trace/Surfaces/Curved/RayBundle.h"

#include <array>

namespace pixelexact
{
/// How rays of a bundle meet one triangle, by ray.
struct TriangleLanes
{
  /// Of each corner, over the edge across from it: all of one sign where the ray meets it.
  std::array<RayBundle::Numbers, 3> weight;
  RayBundle::Numbers t;
  std::array<RayBundle::Numbers, 3> position;
};

/// Kernels dispatched at run time to the instruction set. All of them give the same bits.
struct TriangleKernels
{
  /// Of some of the rays from number `first` on, all of which are longest along `axis`: those that
  /// meet a triangle on either side, or its edges. Writes the weights.
  ///
  /// Corners are moved and sheared to a ray's own coordinates, in which its origin lies at 0 and
  /// its direction along the third, one by one, so that triangles agree on what they share (S.
  /// Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013).
  RaySet (*surround)(const RayLanes& rays, int first, int axis, const RaySet& some,
    const std::array<Vec3, 3>& triangle, TriangleLanes& lanes);
  /// Of these, those whose intervals hold the place where they meet the plane through a corner with
  /// this normal. Writes t and position.
  RaySet (*meet)(const RayLanes& rays, int first, const RaySet& some, const Vec3& corner,
    const Vec3& normal, TriangleLanes& lanes);
};

const TriangleKernels& GetTriangleKernels();
} // namespace pixelexact
