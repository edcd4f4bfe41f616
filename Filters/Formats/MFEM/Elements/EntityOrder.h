// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/CollectionName.h"

#include <array>
#include <vector>

// The unknowns that belong to an entity, and how elements of another orientation see them.
namespace pixelexact::mfem
{
inline constexpr int kGeometries = 8;

/// How many unknowns belong to the inside of an entity.
int EntityUnknowns(const CollectionName& name, Geometry geometry);

/// How many orientations an entity has: segments 2, triangles 6, squares 8, others 1.
int Orientations(Geometry geometry);

/// Entry i: which of the entity's unknowns stands at place i of an element that sees the entity by
/// orientation `o`; -1 - n for the negative of unknown n. `o` counts from 0: segments 0 for +1, 1
/// for -1; others MFEM's number.
std::vector<int> EntityOrder(const CollectionName& name, Geometry geometry, int o);

/// The mixing of pairs of tangential unknowns on a triangle, row-major.
std::array<double, 4> TangentMixing(int orientation);
} // namespace pixelexact::mfem
