// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>

// The number type of the references: 113 bits of mantissa, exponents to 1e+-4932.
namespace pixelexact::testing
{
#if defined(__SIZEOF_FLOAT128__)
using QuadReal = __float128;
#else
using QuadReal = long double;
static_assert(std::numeric_limits<long double>::digits >= 113);
#endif

/// A class of its own, so that the evaluation templates find its operations and none of long
/// double's.
struct Quad
{
  QuadReal v = 0;

  constexpr Quad() = default;
  constexpr Quad(QuadReal value)
    : v(value)
  {
  }
  constexpr Quad(int value)
    : v(value)
  {
  }
  constexpr Quad(double value)
    : v(value)
  {
  }
  constexpr Quad(long double value)
    : v(value)
  {
  }
  explicit constexpr operator double() const { return static_cast<double>(v); }
};

constexpr Quad operator+(Quad a, Quad b)
{
  return a.v + b.v;
}
constexpr Quad operator-(Quad a, Quad b)
{
  return a.v - b.v;
}
constexpr Quad operator-(Quad a)
{
  return -a.v;
}
constexpr Quad operator*(Quad a, Quad b)
{
  return a.v * b.v;
}
constexpr Quad operator/(Quad a, Quad b)
{
  return a.v / b.v;
}
constexpr bool operator<(Quad a, Quad b)
{
  return a.v < b.v;
}
constexpr bool operator==(Quad a, Quad b)
{
  return a.v == b.v;
}
constexpr Quad Abs(Quad a)
{
  return a.v < 0 ? -a.v : a.v;
}
constexpr Quad Min(Quad a, Quad b)
{
  return a.v < b.v ? a : b;
}
constexpr Quad Max(Quad a, Quad b)
{
  return a.v < b.v ? b : a;
}

// Operations of a number type for the evaluation templates; see Lanes-inl.h.
constexpr Quad MulAdd(Quad a, Quad b, Quad c)
{
  return a.v * b.v + c.v;
}
constexpr Quad NegMulAdd(Quad a, Quad b, Quad c)
{
  return c.v - a.v * b.v;
}
/// The quotient is not clamped, because points of the shape never need it.
constexpr Quad CollapsedQuotient(Quad y, Quad t)
{
  return t.v == 0 ? Quad(0) : y / t;
}
constexpr Quad SafeReciprocal(Quad t)
{
  return Quad(1) / t;
}

using QuadVec3 = std::array<Quad, 3>;
/// Row-major.
using QuadMat3 = std::array<QuadVec3, 3>;
} // namespace pixelexact::testing
