// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/CollectionName.h"

#include <array>
#include <vector>

// The unknowns that belong to an entity, and how elements of another orientation see them.

namespace pixelexact::mfem
{
inline constexpr int kGeometries = 8;

/// The number of unknowns inside an entity.
int EntityUnknowns(const CollectionName& name, Geometry geometry);

/// The number of orientations of an entity: segments 2, triangles 6, squares 8, others 1.
int Orientations(Geometry geometry);

/// Entry i is the number of the entity's unknown at place i of an element that has the entity with
/// orientation `o`; -1 - n for the negative of unknown n. `o` counts from 0: segments 0 for +1, 1
/// for -1; others have MFEM's number.
std::vector<int> EntityOrder(const CollectionName& name, Geometry geometry, int o);

/// The mixing of pairs of tangential unknowns on a triangle, row-major.
std::array<double, 4> TangentMixing(int orientation);

// Positions of an element's unknowns in its lattice, in MFEM's local order.

/// Counts towards x = 1, y = 1, z = 1 in MFEM's unit element.
using LatticePoint = std::array<int, 3>;

/// Entry n is the position of unknown n. On pyramids the lattice narrows upwards, as in Bergot's
/// space; unknowns inside Fuentes's pyramids are not in it. z of plane elements is 0.
std::vector<LatticePoint> LocalOrder(const CollectionName& name, Geometry solid);
} // namespace pixelexact::mfem
