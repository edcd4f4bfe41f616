// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace pixelexact::testing
{
/// A number with its derivatives by three variables (forward differentiation). Number is long
/// double, or LongDual<long double> for second derivatives.
template <class Number>
struct LongDual
{
  Number value{};
  std::array<Number, 3> derivative{};

  LongDual(long double constant = 0.0L) // implicit, for constants in formulas
    : value(constant)
  {
  }
  LongDual(const Number& at, const std::array<Number, 3>& slopes)
    : value(at)
    , derivative(slopes)
  {
  }
  /// The variable of this index.
  static LongDual Variable(const Number& at, int index)
  {
    LongDual variable(at, {});
    variable.derivative[index] = Number(1.0L);
    return variable;
  }

  friend LongDual operator+(const LongDual& a, const LongDual& b)
  {
    return Chain(a.value + b.value, a, Number(1.0L), b, Number(1.0L));
  }
  friend LongDual operator-(const LongDual& a, const LongDual& b)
  {
    return Chain(a.value - b.value, a, Number(1.0L), b, Number(-1.0L));
  }
  friend LongDual operator*(const LongDual& a, const LongDual& b)
  {
    return Chain(a.value * b.value, a, b.value, b, a.value);
  }
  friend LongDual operator/(const LongDual& a, const LongDual& b)
  {
    const Number quotient = a.value / b.value;
    return Chain(quotient, a, Number(1.0L) / b.value, b, Number(-1.0L) * quotient / b.value);
  }
  friend bool operator==(const LongDual& a, const LongDual& b) { return a.value == b.value; }

private:
  /// f(a, b), given its value and its derivatives by a and by b.
  static LongDual Chain(
    const Number& value, const LongDual& a, const Number& byA, const LongDual& b, const Number& byB)
  {
    LongDual result(value, {});
    for (int d = 0; d < 3; ++d)
    {
      result.derivative[d] = byA * a.derivative[d] + byB * b.derivative[d];
    }
    return result;
  }
};
} // namespace pixelexact::testing
