// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/MFEM/Elements/CollectionName.h"

// H1 and L2 on tetrahedra, cubes and prisms, triangles and squares.
namespace pixelexact::mfem
{
/// The determinant of the map from MFEM's unit element to ours, the same on all shapes: densities
/// per volume of the one are 1/8 of those of the other.
inline constexpr long double kUnitDensity = 0.125L;
/// The same in the plane.
inline constexpr long double kPlaneUnitDensity = 0.25L;

ElementBasis ScalarBasis(const CollectionName& name, Geometry solid);

/// One function of value one.
ElementBasis ConstantBasis(const CollectionName& name, Shape shape);
} // namespace pixelexact::mfem
