// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/ElementBasis.h"
#include "Formats/Gmsh/ElementType.h"

#include <vector>

// Gmsh's functions on its elements. Gmsh's reference elements map to PixelExact's by
//   hexahedron    xi = (u, v, w)
//   tetrahedron   xi = 2 (u, v, w) - 1
//   prism         xi = (2 u - 1, -w, 2 v - 1)
//   pyramid       xi = (u - w, v - w, 2 w - 1)
//   triangle      xi = (2 u - 1, 0, 2 v - 1), quadrilateral xi = (u, v, 0), of order 0 across
//                 (bases-and-kernels.md)
namespace pixelexact::gmsh
{
/// A basis of one change of basis that takes all of an element's sources.
ElementBasis OnePart(ChangeOfBasis part);

/// Functions that are one at one of the type's nodes and zero at the others, sources in Gmsh's
/// order. Throws Unsupported for incomplete elements whose functions no document defines.
ElementBasis NodalBasis(const ElementType& type);

/// The constant function one, also for plane elements.
ElementBasis ConstantBasis(Shape shape);

/// The functions of a view's values on one shape: f_i = sum_j C_ij m_j, m_j = u^a v^b w^c with row
/// j of the exponents, on pyramids times (1 - w)^(max(a, b) - a - b).
struct Interpolation
{
  int functions = 0;
  std::vector<double> coefficients; ///< functions x functions, row-major
  std::vector<int> exponents;       ///< functions x 3
};

/// The basis of a view's functions. Dimension 2: on the triangles and quadrilaterals of a slab's
/// prisms and hexahedra, with w = 0. Throws Unsupported where the space exceeds the supported ones.
ElementBasis InterpolationBasis(int dimension, Shape shape, const Interpolation& interpolation);
} // namespace pixelexact::gmsh
