// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/Modes-inl.h"

#include <cmath>

// Numbers that carry their derivatives by three variables (forward differentiation), as a number
// type of the evaluation templates: what they differentiate once comes out differentiated twice.
namespace pixelexact::HWY_NAMESPACE
{
struct Dual
{
  double value = 0.0;
  std::array<double, 3> derivative{};

  static Dual Variable(double at, int index)
  {
    Dual result{ at, {} };
    result.derivative[index] = 1.0;
    return result;
  }
};

/// f(a, b), given its value and its derivatives by a and by b.
inline Dual Chain(double value, const Dual& a, double byA, const Dual& b, double byB)
{
  Dual result{ value, {} };
  for (int d = 0; d < 3; ++d)
  {
    result.derivative[d] = byA * a.derivative[d] + byB * b.derivative[d];
  }
  return result;
}

inline Dual operator+(const Dual& a, const Dual& b)
{
  return Chain(a.value + b.value, a, 1.0, b, 1.0);
}
inline Dual operator-(const Dual& a, const Dual& b)
{
  return Chain(a.value - b.value, a, 1.0, b, -1.0);
}
inline Dual operator*(const Dual& a, const Dual& b)
{
  return Chain(a.value * b.value, a, b.value, b, a.value);
}
inline Dual operator/(const Dual& a, const Dual& b)
{
  const double quotient = a.value / b.value;
  return Chain(quotient, a, 1.0 / b.value, b, -quotient / b.value);
}
inline Dual MulAdd(const Dual& a, const Dual& b, const Dual& c)
{
  return a * b + c;
}
inline Dual NegMulAdd(const Dual& a, const Dual& b, const Dual& c)
{
  return c - a * b;
}

template <>
struct NumberTraits<Dual>
{
  using Scalar = double;
  static Dual Splat(double value) { return { value, {} }; }
  static Dual SplatScalar(double value) { return { value, {} }; }
};

/// The same as for Lanes. At the collapsed vertex the derivatives depend on the direction, and are
/// set to zero.
inline Dual CollapsedQuotient(const Dual& y, const Dual& t)
{
  return std::abs(t.value) > 1e-8
    ? y / t
    : Dual{ static_cast<double>(CollapsedQuotient(
              static_cast<long double>(y.value), static_cast<long double>(t.value))),
        {} };
}
inline Dual SafeReciprocal(const Dual& t)
{
  const Dual one{ 1.0, {} };
  return one / (std::abs(t.value) < 1e-30 ? Dual{ 1e-30, t.derivative } : t);
}
} // namespace pixelexact::HWY_NAMESPACE
