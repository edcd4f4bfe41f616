// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/MFEM/Elements/VectorUnknowns.h"

// Nedelec's and Raviart and Thomas's elements in the plane, on the solids of a slab (planar.md).
// Fluxes are those of a slab of the unit element's thickness.

namespace pixelexact::mfem
{
ElementBasis TriangleVectorBasis(const CollectionName& name);
ElementBasis SquareVectorBasis(const CollectionName& name);

/// The functions that are dual to the unknowns of a prism, as products of triangle and line.
ElementBasis PrismVectors(const CollectionName& name, const std::vector<VectorUnknown>& unknowns);
} // namespace pixelexact::mfem
