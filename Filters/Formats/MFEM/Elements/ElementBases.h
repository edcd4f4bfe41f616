// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/MFEM/Elements/CollectionName.h"
#include "Formats/MFEM/Elements/VectorUnknowns.h"

// The bases of the spaces that MFEM's collections name, shape by shape.

namespace pixelexact::mfem
{
/// The determinant of the map from MFEM's unit element to ours, the same on all shapes: densities
/// per volume of the one are 1/8 of those of the other.
inline constexpr long double kUnitDensity = 0.125L;
/// The same in the plane.
inline constexpr long double kPlaneUnitDensity = 0.25L;

/// H1 and L2 on tetrahedra, cubes and prisms, triangles and squares.
ElementBasis ScalarBasis(const CollectionName& name, Geometry solid);

/// The basis of the constant function one.
ElementBasis ConstantBasis(const CollectionName& name, Shape shape);

/// H1 and L2 on pyramids.
ElementBasis PyramidBasis(const CollectionName& name);

/// Nedelec's and Raviart and Thomas's elements.
ElementBasis VectorBasis(const CollectionName& name, Geometry solid);

// Nedelec's and Raviart and Thomas's elements in the plane, on the solids of a slab
// (bases-and-kernels.md). Fluxes are those of a slab of the unit element's thickness.

ElementBasis TriangleVectorBasis(const CollectionName& name);
ElementBasis SquareVectorBasis(const CollectionName& name);

/// The functions that are dual to the unknowns of a prism, as products of triangle and line.
ElementBasis PrismVectors(const CollectionName& name, const std::vector<VectorUnknown>& unknowns);
} // namespace pixelexact::mfem
