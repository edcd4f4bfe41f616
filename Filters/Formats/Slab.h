// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Space.h"
#include "Core/Element/OwnedExpansion.h"
#include "Core/Math/Vec.h"

#include <span>
#include <string>
#include <vector>

// Plane meshes are represented as slabs: triangles become prisms, quadrilaterals hexahedra, whose
// fields are constant across the slab (bases-and-kernels.md). A plane element's space is that of
// its solid, with order 0 across. Elements of a surface in space become such solids as well, one by
// one, each beneath its part of the surface (ShellFace).
namespace pixelexact
{
/// Position of a slab: from middle - thickness / 2 to middle + thickness / 2 along z.
struct Slab
{
  double middle = 0.0;
  double thickness = 1.0; ///< a power of two
  /// The elements lie on a surface in space. `thickness` is then in units of each element.
  bool inSpace = false;
};

/// The slab of a mesh of triangles and quadrilaterals in this box. In a plane z = const, up to
/// `roundings` of the largest coordinate, its thickness is a 32nd to a 64th of the box's shorter
/// side, so that it is flat, or 1 where the box has no extent.
Slab MakeSlab(const Vec3& low, const Vec3& high, double roundings);

/// Throws Unsupported, naming `what`, which is available in a plane z = const only, for a slab in
/// space.
void RequirePlane(const Slab& slab, const std::string& what);

/// The name of a slab element's plane shape: "triangle" or "quadrilateral".
const char* PlaneName(Shape solid);

/// The space of order 1 across.
Space Lifted(const Space& plane);
/// The space of order 0 across, of which that is the lifted one.
Space PlaneOf(const Space& solid);

/// Writes the modes of a map into the slab to `lifted`: three components in the lifted space, from
/// those of x and y, which follow one another in the plane space. `middle` and `half`: of z, in the
/// modes' units, relative to their centre. Determinants have the same sign as in the plane.
void LiftMap(const Space& plane, std::span<const double> modes, double middle, double half,
  std::span<double> lifted);

/// Writes the map of an element of a surface in space to `lifted`. `modes`: x, y and z, one after
/// the other, in the plane space and units of the element; they vanish outside of `needed`. The
/// solid's ShellFace is that surface, up to the rounding of modes. Across, the map is linear, along
/// a polynomial of order at most 3 that approximates the unit normal, times `thickness`. The normal
/// is that of the element's order of vertices. Throws InvalidData where the surface has no normal.
void LiftSurface(const Space& plane, const Space& needed, std::span<const double> modes,
  double thickness, std::span<double> lifted);

/// The surface of such a map: its modes in the plane space, x, y and z, one after the other.
std::vector<double> SurfaceModes(const Space& solid, std::span<const double> map);

/// Replaces such maps, whose surfaces were moved together with their solids, by those of the solids
/// beneath the moved surfaces. Throws as LiftSurface, naming the element by `numbers`.
void LiftAgain(const Slab& slab, std::span<const std::int64_t> numbers, OwnedExpansion& map);
} // namespace pixelexact
