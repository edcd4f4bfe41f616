// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/CollectionName.h"

#include "Core/Basis/BasisFactor.h"

#include <array>
#include <functional>
#include <vector>

// The polynomial spaces of Nedelec's and Raviart and Thomas's elements, each in a basis of its own.
namespace pixelexact::mfem
{
/// Writes the values of all functions at a point of MFEM's unit element, in its axes.
struct VectorSpace
{
  int count = 0;
  std::function<void(const LongVec3& unit, LongVec3* values)> evaluate;
};

VectorSpace TetrahedronSpace(Continuity kind, int order);

/// The same in the plane, at a point of the unit triangle.
struct PlaneSpace
{
  int count = 0;
  std::function<void(long double x, long double y, std::array<long double, 2>* values)> evaluate;
};

PlaneSpace TriangleVectors(Continuity kind, int order);

/// Polynomials on the triangle: a prism's space, of (xi1, xi3) = 2 (x, y) - 1 alone.
Space TriangleSpace(int order);
} // namespace pixelexact::mfem
