// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Core/Basis/ChangeOfBasis.h"
#include "Core/Basis/SimplexNodes.h"

// Changes of basis on triangles and tetrahedra, whose functions are no products of those on lines:
// from a family's functions to modes, in long double.
namespace pixelexact
{
/// The family's nodes; of Bernstein's polynomials, which have none, equispaced ones.
[[nodiscard]] NodeFamily NodesOf(Family family);

/// The factor of the triangle of a prism, (xi1, xi3), with the node or exponent of xi1 slowest.
[[nodiscard]] BasisFactor TriangleFactor(int order, Family family);

/// The factor of a tetrahedron, with that of xi3 fastest.
[[nodiscard]] BasisFactor TetrahedronFactor(const Space& space, Family family);
} // namespace pixelexact
