// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MeshBuilder.h"

#include "Core/Math/Interval.h"
#include "Core/Math/Rounding.h"

#include <mpfr.h>

// Results of operations on doubles without rounding, or with directed rounding: what intervals are
// held against.
namespace pixelexact::testing
{
/// 4400 bits represent any product, sum or square of two doubles exactly. Quotients and roots are
/// rounded in the given direction.
class Exact
{
public:
  explicit Exact(double value = 0.0)
  {
    mpfr_init2(Number, 4400);
    mpfr_set_d(Number, value, MPFR_RNDN);
  }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() { mpfr_clear(Number); }
  mpfr_t Number;
};

using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

/// Whether `interval` contains a op b, checked with bounds of the result on both sides.
inline bool HoldsResult(const Interval& interval, Operation operation, double a, double b)
{
  const Exact x(a);
  const Exact y(b);
  Exact down;
  Exact up;
  operation(down.Number, x.Number, y.Number, MPFR_RNDD);
  operation(up.Number, x.Number, y.Number, MPFR_RNDU);
  if (mpfr_nan_p(down.Number) != 0)
  {
    return interval.lower == -kInfinity && interval.upper == kInfinity;
  }
  return mpfr_cmp_d(up.Number, interval.upper) <= 0 && mpfr_cmp_d(down.Number, interval.lower) >= 0;
}

/// Doubles of all exponents, denormal ones, zeros, neighbours of powers of two, the largest.
inline double AnyDouble(Random& random)
{
  const double kind = random(0.0, 10.0);
  const double sign = random() < 0.0 ? -1.0 : 1.0;
  if (kind < 0.7)
  {
    return sign * 0.0;
  }
  if (kind < 1.4)
  {
    return sign * std::numeric_limits<double>::denorm_min() * std::floor(random(1.0, 40.0));
  }
  if (kind < 2.0)
  {
    return sign * std::numeric_limits<double>::max() * (random() < 0.0 ? 1.0 : 0.5);
  }
  if (kind < 3.0)
  {
    const double power = std::ldexp(1.0, static_cast<int>(random(-1074.0, 1023.0)));
    return sign * (random() < 0.0 ? std::nextafter(power, 0.0) : std::nextafter(power, kInfinity));
  }
  if (kind < 6.0)
  {
    return sign * std::ldexp(random(0.5, 1.0), static_cast<int>(random(-1070.0, 1024.0)));
  }
  return sign * std::ldexp(random(0.5, 1.0), static_cast<int>(random(-4.0, 4.0)));
}
} // namespace pixelexact::testing
