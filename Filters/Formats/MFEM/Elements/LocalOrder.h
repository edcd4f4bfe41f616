// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/CollectionName.h"

#include <array>
#include <vector>

// Where an element's unknowns stand in its lattice: MFEM's local order.
namespace pixelexact::mfem
{
/// Counts towards x = 1, y = 1, z = 1 in MFEM's unit element.
using LatticePoint = std::array<int, 3>;

/// Of unknown n. On pyramids the lattice narrows upwards, as that of Bergot's space; unknowns
/// inside of Fuentes's pyramids are not in it. z of plane elements is 0.
std::vector<LatticePoint> LocalOrder(const CollectionName& name, Geometry solid);
} // namespace pixelexact::mfem
