// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Interval.h"

#include <array>

namespace pixelexact
{
/// A function on the cube [-1,1]^3 enclosed by an affine one and a remainder:
///   f(t) in a + b . t + e for every t of the cube.
/// Every operation encloses the exact results of all functions that its operands enclose, rounding
/// included. The remainder of what varies by O(w) over a box of width w is O(w^2), and stays so in
/// every expression without a division by zero: enclosures tighten quadratically
/// (first-order Taylor models; R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval
/// Analysis, 2009, section 6.4, the mean value form).
struct AffineForm
{
  double a = 0.0;
  std::array<double, 3> b{ 0.0, 0.0, 0.0 };
  Interval e;

  constexpr AffineForm() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number is a constant function.
  constexpr AffineForm(double v)
    : a(v)
  {
  }

  /// All values on the cube.
  [[nodiscard]] Interval Range() const;
};

AffineForm operator+(const AffineForm& f, const AffineForm& g);
AffineForm operator-(const AffineForm& f, const AffineForm& g);
AffineForm operator*(const AffineForm& f, const AffineForm& g);
/// f^2, whose remainder is not negative where f * f's may be.
AffineForm Square(const AffineForm& f);
/// 1 / f; not bounded where f may vanish.
AffineForm Reciprocal(const AffineForm& f);
inline Interval Reciprocal(const Interval& f)
{
  return Interval(1.0) / f;
}
} // namespace pixelexact
