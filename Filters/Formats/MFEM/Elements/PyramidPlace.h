// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"

#include <array>
#include <vector>

// What the vector functions on MFEM's unit pyramid are made of. Fuentes, Keith, Demkowicz and
// Nagaraj: Orientation embedded high order shape functions for the exact sequence elements of all
// shapes, 2015.
namespace pixelexact::mfem
{
/// t^i P_i^(alpha,0)(2 x / t - 1), i <= order; P Jacobi's polynomials, Legendre's for alpha = 0.
std::vector<long double> ScaledJacobi(int order, int alpha, long double x, long double t);

/// The polynomials of one tensor coordinate s in [0,1].
struct LinePlace
{
  LinePlace(int order, long double s);

  /// The derivative of bubble i.
  [[nodiscard]] long double Slope(int i) const { return legendre[i - 1]; }

  std::array<long double, 2> hat;
  std::vector<long double> legendre;
  /// From 2: integrals of Legendre's polynomials, zero at both ends.
  std::vector<long double> bubble;
};

/// A point of the pyramid in tensor coordinates: across 0 and 1, and the height.
struct PyramidPlace
{
  PyramidPlace(int order, const LongVec3& unit);

  /// The gradient of width times hat a of the first coordinate times hat b of the second.
  [[nodiscard]] LongVec3 VertexSlope(int a, int b) const;

  long double z;
  long double width;
  std::array<LinePlace, 2> across;
  LinePlace height;
  std::array<LongVec3, 2> frame; ///< the gradients of the coordinates across, times the width
  LongVec3 normal;               ///< their cross product
};

inline constexpr LongVec3 kUpwards{ 0, 0, 1 };

LongVec3 Cross(const LongVec3& a, const LongVec3& b);
/// f a + g b
LongVec3 Sum(long double f, const LongVec3& a, long double g, const LongVec3& b);
long double Power(long double base, int exponent);

/// Takes functions one by one.
class VectorWriter
{
public:
  explicit VectorWriter(LongVec3* values)
    : Values(values)
  {
  }
  void Put(long double factor, const LongVec3& a) { *Values++ = Sum(factor, a, 0, a); }
  void Put(const LongVec3& a) { *Values++ = a; }

private:
  LongVec3* Values;
};
} // namespace pixelexact::mfem
