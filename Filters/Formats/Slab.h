// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Math/Vec.h"

#include <span>
#include <string>

// Plane meshes are slabs: triangles prisms, quadrilaterals hexahedra, whose fields do not change
// across them (bases-and-kernels.md). A plane element's space is that of its solid, of order 0
// across.
namespace pixelexact
{
/// Where a slab lies: from middle - thickness / 2 to middle + thickness / 2 along z.
struct Slab
{
  double middle = 0.0;
  double thickness = 1.0; ///< a power of two
};

/// The slab of a plane mesh in this box: a 32nd to a 64th of its shorter side thick, so that it is
/// flat, or 1 where it has no extent. Throws Unsupported where the box is no plane z = const,
/// `roundings` of the largest coordinate left aside.
Slab MakeSlab(const Vec3& low, const Vec3& high, double roundings);

/// What an element of a slab is in the plane: "triangle" or "quadrilateral".
const char* PlaneName(Shape solid);

/// The space of order 1 across.
Space Lifted(const Space& plane);

/// The modes of a map into the slab, three components in the lifted space, from those of x and y,
/// one after the other in the plane one. `middle` and `half`: of z, in the modes' units, relative
/// to their centre. Determinants have the sign that they have in the plane.
void LiftMap(const Space& plane, std::span<const double> modes, double middle, double half,
  std::span<double> lifted);
} // namespace pixelexact
