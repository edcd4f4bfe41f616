// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Formats/MFEM/Elements/CollectionName.h"

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

/// Polynomials on the triangle, as a prism's space that depends only on (xi1, xi3) = 2 (x, y) - 1.
Space TriangleSpace(int order);

LongVec3 Cross(const LongVec3& a, const LongVec3& b);

/// The H(curl) and H(div) spaces on MFEM's unit pyramid that go with FuentesFunctions. Their
/// components are polynomials in tensor coordinates, of degree `order` and `order` + 1.
VectorSpace FuentesCurl(int order);
VectorSpace FuentesDiv(int order);
} // namespace pixelexact::mfem
