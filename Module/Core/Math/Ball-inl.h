// SPDX-License-Identifier: BSD-3-Clause
// Intervals in lanes, as middle and radius: what Interval.h is for one number, at a tenth of the
// cost where many points of an element are enclosed together. Included once per instruction set.
//
// Each operation's radius holds the operands' radii and its own rounding. With u = 2^-53, rounding
// to nearest is off by at most u times the result's magnitude, plus 2^-1075 in a product that
// underflows. The radius itself is a sum of products of numbers that are not negative, at most
// eight roundings deep, so kUp = 1 + 16 u makes up for those, and kTiny for every underflow; kTiny
// is a normal number far above them, so that flushing to zero costs no certificate either. NaN and
// infinity pass into the radius and stay there: such a ball bounds nothing.
#if defined(PIXELEXACT_BALL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_BALL_INL_H
#undef PIXELEXACT_BALL_INL_H
#else
#define PIXELEXACT_BALL_INL_H
#endif

#include "Core/Math/Lanes-inl.h"
#include "Core/Math/Rounding.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
namespace ball
{
inline constexpr double kUp = 1.0 + 16.0 * kUnitRoundoff;
inline constexpr double kTiny = 0x1p-1000;

HWY_INLINE Lanes Set(double value)
{
  return NumberTraits<Lanes>::Splat(value);
}
/// An upper bound of the exact sum whose rounding is `sum`.
HWY_INLINE Lanes RoundUp(Lanes sum)
{
  return MulAdd(sum, Set(kUp), Set(kTiny));
}
} // namespace ball

/// All numbers within `radius` of `middle`; every operation encloses the exact results of all its
/// operands' members.
struct Ball
{
  Lanes middle;
  Lanes radius;

  static HWY_INLINE Ball Exactly(Lanes value) { return { value, ball::Set(0.0) }; }
  /// The ball from -radius to radius.
  static HWY_INLINE Ball AroundZero(Lanes radius) { return { ball::Set(0.0), radius }; }
  /// An upper bound of every member's magnitude.
  [[nodiscard]] HWY_INLINE Lanes Magnitude() const { return ball::RoundUp(Abs(middle) + radius); }
};

namespace ball
{
/// A sum or a difference: its middle's rounding on top of the operands' radii.
HWY_INLINE Ball Sum(Lanes middle, Lanes radii)
{
  return { middle, RoundUp(MulAdd(Set(kUnitRoundoff), Abs(middle), radii)) };
}
/// The radius of a product from its operands' radii, added to `start`.
HWY_INLINE Lanes Spread(const Ball& a, const Ball& b, Lanes start)
{
  return MulAdd(Abs(a.middle), b.radius, MulAdd(a.radius, Abs(b.middle) + b.radius, start));
}
} // namespace ball

HWY_INLINE Ball operator+(const Ball& a, const Ball& b)
{
  return ball::Sum(a.middle + b.middle, a.radius + b.radius);
}
HWY_INLINE Ball operator-(const Ball& a, const Ball& b)
{
  return ball::Sum(a.middle - b.middle, a.radius + b.radius);
}
HWY_INLINE Ball operator*(const Ball& a, const Ball& b)
{
  return ball::Sum(a.middle * b.middle, ball::Spread(a, b, ball::Set(0.0)));
}
/// Without a fused operation the product has a rounding of its own.
HWY_INLINE Lanes ProductRounding(const Ball& a, const Ball& b)
{
#if HWY_NATIVE_FMA
  (void)a;
  (void)b;
  return ball::Set(0.0);
#else
  return ball::Set(kUnitRoundoff) * Abs(a.middle * b.middle);
#endif
}
HWY_INLINE Ball MulAdd(const Ball& a, const Ball& b, const Ball& c)
{
  return ball::Sum(
    MulAdd(a.middle, b.middle, c.middle), ball::Spread(a, b, c.radius) + ProductRounding(a, b));
}
HWY_INLINE Ball NegMulAdd(const Ball& a, const Ball& b, const Ball& c)
{
  return ball::Sum(
    NegMulAdd(a.middle, b.middle, c.middle), ball::Spread(a, b, c.radius) + ProductRounding(a, b));
}
/// The result is unbounded where `b` might be zero, or is close to it.
///
/// With q the quotient of the middles, y / t - q = (y_m - q t_m + dy - q dt) / t, and the first
/// difference is |t_m| times the rounding of q.
HWY_INLINE Ball operator/(const Ball& a, const Ball& b)
{
  const Lanes q = a.middle / b.middle;
  const Lanes size = Abs(b.middle);
  const Lanes least = (size - b.radius) * ball::Set(1.0 - 16.0 * kUnitRoundoff);
  const Lanes spread = MulAdd(Abs(q), MulAdd(ball::Set(kUnitRoundoff), size, b.radius),
    MulAdd(size, ball::Set(ball::kTiny), a.radius));
  // Underflow in `spread` is at most kTiny, and `least` is far above it.
  const LaneMask apart = ball::Set(0x1p-900) <= least;
  return { Select(apart, q, ball::Set(0.0)),
    Select(apart, ball::RoundUp((spread + ball::Set(ball::kTiny)) / least),
      ball::Set(std::numeric_limits<double>::infinity())) };
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
