// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <array>

namespace pixelexact
{
/// A box of eta in [-1,1]^3, its ends exact. In xi it is a convex polytope: each end is a plane,
///   eta_d <= b  <=>  1 + xi_d <= (1 + b) s_d(xi),
/// s_d being 1 or the collapsed extent of the shape at xi.
struct EtaBox
{
  Vec3 lower{ -1.0 };
  Vec3 upper{ 1.0 };

  [[nodiscard]] bool Holds(const Vec3& eta) const { return Box3{ lower, upper }.Contains(eta); }
};

/// The box of the corners in xi; the polytope lies in it, up to rounding.
Box3 HullInXi(Shape shape, const EtaBox& box);

/// The outward normals in xi of a box's ends: lower and upper of eta_1, of eta_2, of eta_3.
std::array<double[3], 6> EndNormals(Shape shape, const EtaBox& box);
/// The distance of a xi of the box from its k-th end, along the end's normal.
double DepthOf(Shape shape, const EtaBox& box, int end, const Vec3& xi);
/// The middles of the ends, then that of the box, in xi.
std::array<Vec3, 7> MiddlesOf(Shape shape, const EtaBox& box);
} // namespace pixelexact
