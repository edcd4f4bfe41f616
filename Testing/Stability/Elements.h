// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

namespace pixelexact::testing
{
/// Row-major.
using LongMat3 = std::array<LongVec3, 3>;
LongMat3 Identity();
LongMat3 Diagonal(long double x, long double y, long double z);
/// A turn about no axis in particular.
LongMat3 Rotation();
/// Two edges at this angle, the third normal to both.
LongMat3 Skew(double degrees);
LongMat3 Product(const LongMat3& a, const LongMat3& b);

/// Adds `size` times a matrix times Curved, of order 3, about `centre`.
void AddAffine(MeshBuilder& mesh, Shape shape, const LongMat3& matrix, double size,
  const Vec3& centre = Vec3(0.0));

/// Adds the identity and random modes of all orders, whose size decreases by a factor of two with
/// each order. The Jacobian is within 0.3 of the identity, so the map is injective on the shape
/// enlarged by `reach` in eta.
void AddPerturbed(MeshBuilder& mesh, const Space& space, double reach);

/// Adds a map of order 3 whose determinant falls to `least` at xi1 = 0 and grows as xi1^2 on both
/// sides; injective on all of space.
void AddPinched(MeshBuilder& mesh, Shape shape, double least);

/// Adds a parabola about the origin, thickened radially: quadratic along, linear across; `closed`
/// in [0, 1) is how far its ends reach back. Injective where 1 + 0.3 xi2 > 0. Returns its order.
int AddLetterC(MeshBuilder& mesh, Shape shape, double closed);

/// Adds a polynomial of order 20 close to a logarithmic spiral, thickened radially. Along xi1 in
/// hexahedra, along xi2 in prisms; further orders are linear, or 20 as well.
void AddSpiral(MeshBuilder& mesh, const Space& space, double turns);
Space SpiralHexahedron();
Space SpiralPrism();

/// The spiral's midline at a in [-1,1].
std::array<long double, 2> SpiralMidline(double turns, long double a);

/// Modes of `from` in the larger space `to` of the same shape.
std::vector<double> Lift(const Space& from, const double* modes, const Space& to);
} // namespace pixelexact::testing
