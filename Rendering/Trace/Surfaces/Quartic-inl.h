// SPDX-License-Identifier: BSD-3-Clause
// Roots of quartics, in lanes. Included once per instruction set.
#if defined(PIXELEXACT_QUARTIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_QUARTIC_INL_H
#undef PIXELEXACT_QUARTIC_INL_H
#else
#define PIXELEXACT_QUARTIC_INL_H
#endif

#include "Trace/Surfaces/PairRay-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The value of c[0] + c[1] s + ...; S is Lanes or a Pair.
template <int N, class S>
HWY_INLINE Pair Horner(const Pair (&c)[N], const S& s)
{
  Pair value = c[N - 1];
  for (int i = N - 2; i >= 0; --i)
  {
    const Pair product = Term(value, s);
    const Pair sum = ExactSum(product.high, c[i].high);
    value = FastSum(sum.high, sum.low + (product.low + c[i].low));
  }
  return value;
}

/// The derivative at s, in doubles.
template <int N>
HWY_INLINE Lanes SlopeOf(const Pair (&c)[N], Lanes s)
{
  Lanes slope = Splat(N - 1.0) * c[N - 1].high;
  for (int i = N - 2; i > 0; --i)
  {
    slope = slope * s + Splat(static_cast<double>(i)) * c[i].high;
  }
  return slope;
}

/// The polynomial at s, in doubles.
template <int N>
HWY_INLINE Lanes RoughValue(const Pair (&c)[N], Lanes s)
{
  Lanes value = c[N - 1].high;
  for (int i = N - 2; i >= 0; --i)
  {
    value = value * s + c[i].high;
  }
  return value;
}

/// Newton's steps from s, in the lanes `wanted`, to the sign change of a function between low and
/// high; the function rises in the lanes `rising`. Steps stay between ends with known signs, and
/// every fourth step is a bisection, because Newton's method converges slowly near a multiple root.
/// The search ends when steps are at most `tolerance`.
template <class Value, class Slope>
HWY_INLINE Lanes Search(const Value& valueAt, const Slope& slopeAt, Lanes low, Lanes high, Lanes s,
  LaneMask rising, LaneMask wanted, int mostSteps, double tolerance)
{
  const Lanes zero = Splat(0.0);
  const Lanes half = Splat(0.5);
  const Lanes enough = Splat(tolerance);
  LaneMask open = wanted;
  for (int step = 1; step <= mostSteps && !None(open); ++step)
  {
    const Lanes value = valueAt(s);
    const LaneMask above = zero < value;
    const LaneMask before = Or(AndNot(rising, above), AndNot(above, rising));
    low = Select(And(open, before), s, low);
    high = Select(AndNot(open, before), s, high);
    const Lanes moved = s - value / slopeAt(s);
    const LaneMask inside = And(low <= moved, moved <= high);
    const LaneMask near = And(inside, Abs(moved - s) <= enough);
    const LaneMask narrow = (high - low) <= enough;
    const LaneMask bisects = AndNot(step % 4 == 0 ? open : AndNot(open, inside), near);
    s = Select(bisects, (low + high) * half, Select(And(open, inside), moved, s));
    open = AndNot(open, Or(near, narrow));
  }
  return s;
}

/// The sign change of a polynomial that is monotone between low and high, to the precision of a
/// double. Starts from a search in doubles and uses signs in pairs.
template <int N>
HWY_INLINE Lanes SignChange(
  const Pair (&c)[N], Lanes low, Lanes high, LaneMask rising, LaneMask wanted)
{
  const auto slope = [&](Lanes s) PIXELEXACT_INLINED { return SlopeOf(c, s); };
  const Lanes guess = Search([&](Lanes s) PIXELEXACT_INLINED { return RoughValue(c, s); }, slope,
    low, high, (low + high) * Splat(0.5), rising, wanted, 20, 0x1p-26);
  return Search([&](Lanes s) PIXELEXACT_INLINED { return Horner(c, s).high; }, slope, low, high,
    guess, rising, wanted, 240, 0x1p-53);
}

/// Refines a root of a quartic between low and high by one Newton step, from the precision of a
/// double to that of the coefficients.
HWY_INLINE Pair Polished(const Pair (&c)[5], Lanes root, Lanes low, Lanes high)
{
  const Lanes zero = Splat(0.0);
  const Lanes change = Horner(c, root).high / SlopeOf(c, root);
  const Lanes moved = root - change;
  // A longer step results from a vanishing slope, not from rounding.
  const LaneMask small = And(Abs(change) <= Splat(0x1p-40), And(low <= moved, moved <= high));
  return FastSum(root, Select(small, zero - change, zero));
}

/// Refines the only root of a quartic between low and high from an approximation in doubles. The
/// quartic must be that of a torus: |f''| <= 24, and |f| > 2^-24 at low and high. `failed` is set
/// in lanes where this is not proven.
HWY_INLINE Pair PolishedNear(
  const Pair (&c)[5], Lanes root, Lanes low, Lanes high, LaneMask wanted, LaneMask& failed)
{
  const Lanes zero = Splat(0.0);
  // Newton's step from s is `change`. By Kantorovich's theorem there is a root within twice the
  // step if |f''| times the step is at most |f'| / 2. It lies between low and high, because no
  // other root is so close to these. The remaining error is at most (12 change^2 + slope's error
  // |change|) / |f'|. The iteration ends when it is below the effect of f's rounding.
  const auto isLeft = [&](Lanes change) PIXELEXACT_INLINED
  { return Splat(0x1p-93) < change * (Splat(12.0) * change + Splat(0x1p-46)); };
  const Pair value = Horner(c, root);
  const Lanes slope = SlopeOf(c, root);
  const Lanes change = value.high / slope;
  const Lanes size = Abs(change);
  const LaneMask sure = And(
    And(size <= Splat(0x1p-31), Splat(64.0) * size <= Abs(slope)), And(low <= root, root <= high));
  failed = Or(failed, AndNot(wanted, sure));
  Pair s = FastSum(root, zero - change);
  LaneMask open = And(And(wanted, sure), isLeft(size));
  for (int step = 0; step < 3 && !None(open); ++step)
  {
    const Lanes more = Horner(c, s).high / SlopeOf(c, s.high);
    const Pair next = Plus(s, Pair::Of(zero - more));
    s = { Select(open, next.high, s.high), Select(open, next.low, s.low) };
    open = And(open, isLeft(Abs(more)));
  }
  failed = Or(failed, open);
  return s;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
