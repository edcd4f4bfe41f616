// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/CollectionName.h"

#include "Core/Basis/BasisFactor.h"

#include <vector>

// The unknowns of Nedelec's and Raviart and Thomas's elements.
namespace pixelexact::mfem
{
/// Its value is that of the field, in MFEM's unit element, at a point and along a direction:
/// tangential of H(curl), normal of H(div).
struct VectorUnknown
{
  LongVec3 node;
  LongVec3 direction;
};

/// In MFEM's local order. `name` gives kind and order; the points on lines are those of its bases
/// on cubes, and Gauss-Lobatto and Gauss points on the other solids.
std::vector<VectorUnknown> VectorUnknowns(const CollectionName& name, Geometry solid);

/// The points in [0,1] of the unknowns' coordinates on a cube, by axis: those of a component along
/// `axis`.
std::vector<long double> CubeLine(const CollectionName& name, int component, int axis);
} // namespace pixelexact::mfem
