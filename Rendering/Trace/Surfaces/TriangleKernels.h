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
  RayBundle::Numbers t;
  std::array<RayBundle::Numbers, 3> position;
  /// Of the second and the third corner, of a sum of 1.
  std::array<RayBundle::Numbers, 2> weight;
  /// Rays that have no part of a corner: they meet the edge across from it.
  std::array<RaySet, 3> across;
};

/// Kernels dispatched at run time to the instruction set. All of them give the same bits.
struct TriangleKernels
{
  /// Of some of a bundle's rays, those that meet a triangle with this normal on either side, or its
  /// edges, within their intervals.
  ///
  /// Corners are moved and sheared to a ray's own coordinates, in which it is the third axis, one
  /// by one, so that triangles agree on what they share (S. Woop, C. Benthin, I. Wald, Watertight
  /// Ray/Triangle Intersection, JCGT 2(1), 2013; there a ray's coordinates begin at its origin,
  /// here at the bundle's z0, next to the triangles). `rays` are those that the bundle was made
  /// of.
  RaySet (*meet)(const RayBundle& bundle, const RayLanes& rays, const RaySet& some,
    const std::array<Vec3, 3>& triangle, const Vec3& normal, TriangleLanes& lanes);
};

const TriangleKernels& GetTriangleKernels();
} // namespace pixelexact
