// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/DoublePair.h"

#include <cmath>

// Sums and products of pairs of doubles, one at a time, for the coefficients of surfaces. The error
// bounds of Pair-inl.h hold here.
namespace pixelexact
{
/// a + b, exactly.
inline DoublePair ExactSum(double a, double b)
{
  const double sum = a + b;
  const double added = sum - a;
  return { sum, (a - (sum - added)) + (b - added) };
}

/// a b, exactly unless it underflows.
inline DoublePair ExactProduct(double a, double b)
{
  const double product = a * b;
  return { product, std::fma(a, b, -product) };
}

inline DoublePair operator-(const DoublePair& a)
{
  return { -a.high, -a.low };
}
inline DoublePair operator+(const DoublePair& a, const DoublePair& b)
{
  const DoublePair sum = ExactSum(a.high, b.high);
  return ExactSum(sum.high, sum.low + (a.low + b.low));
}
inline DoublePair operator-(const DoublePair& a, const DoublePair& b)
{
  return a + -b;
}
inline DoublePair operator*(const DoublePair& a, const DoublePair& b)
{
  const DoublePair product = ExactProduct(a.high, b.high);
  return ExactSum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
inline DoublePair operator*(double a, const DoublePair& b)
{
  return DoublePair{ a, 0.0 } * b;
}
/// Relative error: a few 2^-106.
inline DoublePair operator/(const DoublePair& a, const DoublePair& b)
{
  const double high = a.high / b.high;
  const DoublePair rest = a - high * b;
  return ExactSum(high, rest.high / b.high);
}
/// The square root of a positive number. Relative error: a few 2^-106.
inline DoublePair SquareRoot(const DoublePair& a)
{
  const double high = std::sqrt(a.high);
  const DoublePair rest = a - ExactProduct(high, high);
  return ExactSum(high, rest.high / (2.0 * high));
}

/// Exact, unless it underflows.
inline DoublePair TimesPowerOfTwo(const DoublePair& a, int exponent)
{
  return { std::ldexp(a.high, exponent), std::ldexp(a.low, exponent) };
}
} // namespace pixelexact
