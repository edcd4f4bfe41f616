// SPDX-License-Identifier: BSD-3-Clause
// Balls (Ball-inl.h) as a number type of the evaluation templates (Modes-inl.h).
//
// In plain interval arithmetic a three-term recurrence magnifies rounding by about 2.4 per step,
// because the bounds do not include that the errors cancel. Values are therefore computed in pairs
// of doubles, where that growth, from 2^-100 on, stays below the last bit of a double, and the
// width of the argument enters through the derivative over it:  P_n(Z) lies in P_n(z) + P_n'(Z) (Z
// - z). Derivatives are only ever multiplied by the small width of a box and stay in ball
// arithmetic. Included once per instruction set.
#if defined(PIXELEXACT_BALL_MODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_BALL_MODES_INL_H
#undef PIXELEXACT_BALL_MODES_INL_H
#else
#define PIXELEXACT_BALL_MODES_INL_H
#endif

#include "Core/Basis/Modes-inl.h"
#include "Core/Basis/PairRecurrence.h"
#include "Core/Math/Ball-inl.h"
#include "Core/Math/Pair-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
template <>
struct NumberTraits<Ball>
{
  using Scalar = DoublePair;
  static HWY_INLINE Ball Splat(double value) { return Ball::Exactly(ball::Set(value)); }
  static HWY_INLINE Ball SplatScalar(const DoublePair& value)
  {
    const Lanes high = ball::Set(value.high);
    return { high, Abs(high) * ball::Set(2.0 * kUnitRoundoff) };
  }
};

/// No quotient is known at the collapsed vertex itself.
HWY_INLINE Ball CollapsedQuotient(const Ball& y, const Ball& t)
{
  return y / t;
}
HWY_INLINE Ball SafeReciprocal(const Ball& t)
{
  return NumberTraits<Ball>::Splat(1.0) / t;
}

/// Above all of an operation's rounding in pairs, with the neglected part of its constants; see
/// Pair-inl.h.
inline constexpr double kPairError = 0x1p-100;

/// One value of a recurrence, and a bound of its error.
struct BoundedPair
{
  Pair value;
  Lanes error;

  /// `width`: how far the function may be from this value over the argument's ball.
  [[nodiscard]] HWY_INLINE Ball Widened(Lanes width) const
  {
    return { value.high, ball::RoundUp(Abs(value.low) + error + width) };
  }
};

/// slope * last - weight * previous. The slope is a sum of products of the magnitudes `terms`,
/// made with at most four operations, the weight a product of at most three factors.
HWY_INLINE BoundedPair NextOf(const Pair& slope, Lanes terms, const BoundedPair& last,
  const Pair& weight, const BoundedPair& previous)
{
  // Errors in units of u^2: 22 for the slope in terms of `terms`, 20 for the weight, 9 for each
  // product here and 4 for the difference: less than 64, of kPairError. Errors of the values
  // themselves pass on with the factors' exact magnitudes. Underflow is below kMin kPairError in
  // a factor, and below what RoundUp adds in a product.
  constexpr double kMin = 0x1p-900;
  const Lanes one = ball::Set(kPairError);
  terms = terms + ball::Set(kMin);
  const Lanes steep = MulAdd(one, terms, Abs(slope.high) + Abs(slope.low));
  const Lanes weighty = Abs(weight.high) + Abs(weight.low) + ball::Set(kMin);
  const Lanes heavy = MulAdd(one, weighty, weighty);
  const Lanes rounding =
    one * MulAdd(terms, Abs(last.value.high), weighty * Abs(previous.value.high));
  return { slope * last.value - weight * previous.value,
    ball::RoundUp(MulAdd(steep, last.error, MulAdd(heavy, previous.error, rounding))) };
}

/// The tables of values over a ball; those with derivatives come from the template.
template <bool kGradient>
HWY_INLINE void FillPolynomials(
  const RecurrenceStep<DoublePair>* step, int last, const Ball& z, Ball* value, Ball* derivative)
{
  if constexpr (kGradient)
  {
    FillPolynomials<true, Ball>(step, last, z, value, derivative);
  }
  else
  {
    const Lanes zero = ball::Set(0.0);
    const bool wide = !None(AndNot(zero <= zero, z.radius <= zero));
    Ball loose[kMaxOrder + 1];
    Ball slope[kMaxOrder + 1];
    if (wide)
    {
      FillPolynomials<true, Ball>(step, last, z, loose, slope);
    }
    const Pair at = Pair::Of(z.middle);
    BoundedPair previous{ Pair::Of(zero), zero };
    BoundedPair current{ Pair::Of(ball::Set(1.0)), zero };
    value[0] = Ball::Exactly(ball::Set(1.0));
    for (int n = 0; n < last; ++n)
    {
      const Pair b = Pair::Of(step[n].b);
      const Pair a = Pair::Of(step[n].a);
      const Lanes terms = MulAdd(Abs(a.high), Abs(z.middle), Abs(b.high));
      const BoundedPair next = NextOf(a * at + b, terms, current, Pair::Of(step[n].c), previous);
      previous = current;
      current = next;
      value[n + 1] = current.Widened(wide ? slope[n + 1].Magnitude() * z.radius : zero);
    }
  }
}

template <bool kGradient>
HWY_INLINE void FillScaled(const RecurrenceStep<DoublePair>* step, int last, const Ball& y,
  const Ball& t, Ball* value, Ball* byY, Ball* byT)
{
  if constexpr (kGradient)
  {
    FillScaled<true, Ball>(step, last, y, t, value, byY, byT);
  }
  else
  {
    Ball loose[kMaxOrder + 1];
    Ball slopeY[kMaxOrder + 1];
    Ball slopeT[kMaxOrder + 1];
    FillScaled<true, Ball>(step, last, y, t, loose, slopeY, slopeT);
    const Lanes zero = ball::Set(0.0);
    const Pair atY = Pair::Of(y.middle);
    const Pair atT = Pair::Of(t.middle);
    const Pair square = ExactProduct(t.middle, t.middle);
    BoundedPair previous{ Pair::Of(zero), zero };
    BoundedPair current{ Pair::Of(ball::Set(1.0)), zero };
    value[0] = Ball::Exactly(ball::Set(1.0));
    for (int n = 0; n < last; ++n)
    {
      const Pair a = Pair::Of(step[n].a);
      const Pair b = Pair::Of(step[n].b);
      const Lanes terms = MulAdd(Abs(a.high), Abs(y.middle), Abs(b.high) * Abs(t.middle));
      const BoundedPair next =
        NextOf(a * atY + b * atT, terms, current, Pair::Of(step[n].c) * square, previous);
      previous = current;
      current = next;
      value[n + 1] = current.Widened(
        MulAdd(slopeY[n + 1].Magnitude(), y.radius, slopeT[n + 1].Magnitude() * t.radius));
    }
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
