// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/DoublePair.h"
#include "Core/Math/Vec.h"
#include "Trace/Rays.h"
#include "Trace/Surfaces/Curved/RayBundle.h"
#include "Trace/Surfaces/HitSlots.h"

#include <array>

namespace pixelexact
{
/// A plane through a point; the unit normal points out of the body.
struct ConvexFace
{
  Vec3 point;
  Vec3 normal;
};

/// Intersection kernels in lanes, dispatched at run time to the instruction set. All of them give
/// the same bits.
struct ConvexKernels
{
  void (*meet)(const ConvexFace* faces, int count, const RayLanes& rays, HitSlots& hits);
};

const ConvexKernels& GetConvexKernels();

/// (x-c)^T Q (x-c) + 2 b.(x-c) + k.
struct QuadraticForm
{
  Vec3 centre{ 0.0 };
  DoublePair Q[6]; ///< xx, yy, zz, xy, yz, xz
  DoublePair b[3];
  DoublePair k;
};

/// |x-c|^2 - (v.(x-c))^2 + k: cylinders and cones.
struct AxisForm
{
  Vec3 centre{ 0.0 };
  DoublePair v[3];
  DoublePair k;
};

/// Intersection kernels in lanes, dispatched at run time to the instruction set. All of them give
/// the same bits.
struct QuadricKernels
{
  void (*meetSphere)(
    const Vec3& centre, const DoublePair& squaredRadius, const RayLanes& rays, HitSlots& hits);
  void (*meetRound)(const AxisForm& form, const RayLanes& rays, HitSlots& hits);
  void (*meetQuadric)(const QuadraticForm& form, const RayLanes& rays, HitSlots& hits);
  /// For a form with b = 0.
  void (*meetCentred)(const QuadraticForm& form, const RayLanes& rays, HitSlots& hits);
};

const QuadricKernels& GetQuadricKernels();

/// f(y) = (|y|^2 - R^2 - r^2)^2 + (v.y)^2 - (2 R r)^2 with y = unit (x - centre); all members are
/// in these units.
struct TorusForm
{
  Vec3 centre;
  double unit;        ///< a power of two
  DoublePair axis[3]; ///< v, of length 2 R
  DoublePair sum;     ///< R^2 + r^2
  DoublePair product; ///< (2 R r)^2
  double slab;        ///< bound of |v.y| on the torus, a little more than 2 R r
  double reach;       ///< bound of |y| on the torus, a little more than R + r; at most 1
};

/// Intersection kernels in lanes, dispatched at run time to the instruction set. All of them give
/// the same bits.
struct TorusKernels
{
  void (*meet)(const TorusForm& form, const RayLanes& rays, HitSlots& hits);
};

const TorusKernels& GetTorusKernels();

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
