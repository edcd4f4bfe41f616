// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Math/Vec.h"

#include <span>
#include <string>

// Plane meshes are represented as slabs: triangles become prisms, quadrilaterals hexahedra, whose
// fields are constant across the slab (bases-and-kernels.md). A plane element's space is that of
// its solid, with order 0 across.
namespace pixelexact
{
/// Position of a slab: from middle - thickness / 2 to middle + thickness / 2 along z.
struct Slab
{
  double middle = 0.0;
  double thickness = 1.0; ///< a power of two
};

/// The slab of a plane mesh in this box. Its thickness is a 32nd to a 64th of the box's shorter
/// side, so that it is flat, or 1 where the box has no extent. Throws Unsupported where the box is
/// not a plane z = const up to `roundings` of the largest coordinate.
Slab MakeSlab(const Vec3& low, const Vec3& high, double roundings);

/// The name of a slab element's plane shape: "triangle" or "quadrilateral".
const char* PlaneName(Shape solid);

/// The space of order 1 across.
Space Lifted(const Space& plane);

/// Writes the modes of a map into the slab to `lifted`: three components in the lifted space, from
/// those of x and y, which follow one another in the plane space. `middle` and `half`: of z, in the
/// modes' units, relative to their centre. Determinants have the same sign as in the plane.
void LiftMap(const Space& plane, std::span<const double> modes, double middle, double half,
  std::span<double> lifted);
} // namespace pixelexact
