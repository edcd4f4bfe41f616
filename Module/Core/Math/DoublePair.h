// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pixelexact
{
/// A number as the unevaluated sum of a double and a correction below half an ulp of it.
struct DoublePair
{
  double high = 0.0;
  double low = 0.0;
};

/// The quotient of two whole numbers (or other doubles whose quotient is a normal number): off by
/// at most 2^-105 of it. The remainder of a rounded quotient is a double (T. Dekker, A
/// floating-point technique for extending the available precision, Numerische Mathematik 18, 1971).
inline DoublePair Quotient(double numerator, double denominator)
{
  const double high = numerator / denominator;
  return { high, std::fma(-high, denominator, numerator) / denominator };
}
} // namespace pixelexact
