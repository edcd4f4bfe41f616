// SPDX-License-Identifier: BSD-3-Clause
// The quartic of a torus along rays, and its roots from doubles. Included once per instruction set.
#if defined(PIXELEXACT_TORUS_QUARTIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_TORUS_QUARTIC_INL_H
#undef PIXELEXACT_TORUS_QUARTIC_INL_H
#else
#define PIXELEXACT_TORUS_QUARTIC_INL_H
#endif

#include "Trace/Surfaces/Quartic-inl.h"
#include "Trace/Surfaces/SurfaceKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// f(s) on a ray, and bounds for its evaluation.
struct RayQuartic
{
  Pair f[5];
  Lanes end;       ///< the ray is outside at -end and end
  Lanes noise;     ///< bound of f's rounding errors
  LaneMask isNear; ///< the ray may meet the torus
};

HWY_INLINE Pair Scaled(const Pair& a, double powerOfTwo)
{
  return { a.high * Splat(powerOfTwo), a.low * Splat(powerOfTwo) };
}

HWY_INLINE RayQuartic QuarticOf(const TorusForm& form, const PairRay& ray)
{
  const Pair y[3] = { Scaled(ray.p[0], form.unit), Scaled(ray.p[1], form.unit),
    Scaled(ray.p[2], form.unit) };
  const Pair v[3] = { Pair::Of(form.axis[0]), Pair::Of(form.axis[1]), Pair::Of(form.axis[2]) };
  const Pair yy = PairDot(y, y);
  const Pair yv = PairDot(y, v);
  const Pair dv = PairDot(v, ray.d);
  const Pair rim = Plus(yy, Negative(Pair::Of(form.sum)));
  // d.d = 1 + e. e and y.d have the size of a rounding, so doubles suffice for them.
  const Lanes e = (ray.squaredLength.high - Splat(1.0)) + ray.squaredLength.low;
  const PairSum product = SumOfTerms(y, ray.d);
  const Lanes yd = product.high + product.low;
  RayQuartic quartic;
  Pair(&f)[5] = quartic.f;
  f[4] = { Splat(1.0), e * (Splat(2.0) + e) };
  f[3] = Pair::Of(Splat(4.0) * yd * ray.squaredLength.high);
  const Pair twice = Scaled(rim, 2.0);
  PairSum f2{ twice.high, twice.low + (twice.high * e + Splat(4.0) * (yd * yd)) };
  f2.Add(Term(dv, dv));
  f[2] = f2.Get();
  const Pair across = Term(yv, dv);
  PairSum f1{ across.high, across.low };
  f1.Add(Term(twice, yd));
  f[1] = Scaled(f1.Get(), 2.0);
  const Pair square = Term(rim, rim);
  PairSum f0{ square.high, square.low };
  f0.Add(Term(yv, yv));
  f0.Add(Negative(Pair::Of(form.product)));
  f[0] = f0.Get();
  quartic.end = Splat(1.001 * form.reach);
  quartic.isNear = yy.high <= Splat(form.reach * form.reach);
  // No term of f exceeds 9, and the error of a sum is below a hundred u^2 of the terms. The
  // distance of the ray's origin adds u^2 of itself to y's error.
  quartic.noise = Splat(0x1p-96) * (Splat(1.0) + Abs(ray.t0) * Splat(form.unit));
  return quartic;
}

/// Three points in order such that f is monotone between them, and between them and the ends.
HWY_INLINE void Extrema(
  const RayQuartic& quartic, const Pair (&slope)[4], LaneMask wanted, Lanes (&extrema)[3])
{
  const Pair(&f)[5] = quartic.f;
  const Lanes zero = Splat(0.0);
  const Lanes end = quartic.end;
  // Zeros of f'' / 2 = 6 f4 s^2 + 3 f3 s + f2.
  const Lanes b = Splat(3.0) * f[3].high;
  const Lanes discriminant = b * b - Splat(24.0) * f[4].high * f[2].high;
  const Lanes root = Sqrt(Max(discriminant, zero));
  const Lanes scale = Splat(12.0) * f[4].high;
  const auto within = [&](Lanes s) PIXELEXACT_INLINED { return Max(Min(s, end), zero - end); };
  const Lanes ends[4] = { zero - end, within((zero - b - root) / scale), within((root - b) / scale),
    end };
  Lanes at[4];
  for (int i = 0; i < 4; ++i)
  {
    at[i] = Horner(slope, ends[i]).high;
  }
  for (int i = 0; i < 3; ++i)
  {
    const LaneMask rising = And(at[i] < zero, zero <= at[i + 1]);
    const LaneMask falling = And(zero <= at[i], at[i + 1] < zero);
    const LaneMask changes = And(wanted, Or(rising, falling));
    extrema[i] = None(changes)
      ? ends[i]
      : Select(changes, SignChange(slope, ends[i], ends[i + 1], rising, changes), ends[i]);
  }
}

/// Signs of a ray's f at approximate extrema, from doubles.
///
/// With t0 at the ray's closest point, f is nearly s^4 + g2 s^2 + g1 s + g0. The rounding of y (7 u
/// |t0|), of d and of the coefficients changes f and f' by less than `error`, some 2^-44 (1 +
/// |t0|), for |s| <= 1.01.
struct RoughQuartic
{
  Lanes extrema[3]; ///< in order, approximately those of f
  Lanes at[3];      ///< f there
  LaneMask certain;

  /// The extrema are the roots a and -a/2 +- h of a cubic with the same x^2 and x terms as f'/4. If
  /// the latter two are not real, their real part replaces both. Let `rest` bound the difference of
  /// the cubic and f'/4. At an extremum c of f, the product of its distances from the three roots
  /// is at most `rest`, so one of these is at most rho = rest^(1/3) away. From that root to c, f
  /// changes by at most 12 rho^2, because f''/2 is at most 12. So f's signs at the separators give
  /// the number of roots between them, 0 or 1, if |f| there is larger than 48 rho^2:
  ///
  /// A further root would require an extremum between the same separators at which f is zero or has
  /// the other sign than at the separator within rho of it, which is impossible. If the separators'
  /// signs differ, it would require a minimum that is not above zero near the positive one,
  /// followed by a maximum that is not below zero near the negative one. But these have the
  /// opposite order, unless the separators are within 2 rho of each other and both within 2 rho of
  /// an extremum of the other sign.
  HWY_INLINE RoughQuartic(Lanes g2, Lanes g1, Lanes g0, Lanes error, Lanes end)
  {
    const Lanes zero = Splat(0.0);
    const Lanes half = Splat(0.5);
    const Lanes P = half * g2;
    const Lanes Q = Splat(0.25) * g1;
    const Lanes size = Abs(Q);
    // Solves a^3 + P a = |Q| by Halley's steps.
    Lanes a = Sqrt(Max(zero - P, zero) + Sqrt(size));
    for (int step = 0; step < 3; ++step)
    {
      const Lanes square = a * a;
      const Lanes value = (square + P) * a - size;
      const Lanes slope = Splat(3.0) * square + P;
      a = a - value * slope / (slope * slope - value * (Splat(3.0) * a));
    }
    const Lanes rest = Abs((a * a + P) * a - size) + error;
    const Lanes b = half * a + Sqrt(Max(zero - P - Splat(0.75) * (a * a), zero));
    const LaneMask mirrored = zero < Q;
    const Lanes first = zero - Select(mirrored, a, b);
    const Lanes third = Select(mirrored, b, a);
    const auto within = [&](Lanes s) PIXELEXACT_INLINED { return Max(Min(s, end), zero - end); };
    extrema[0] = within(first);
    extrema[1] = within(zero - (first + third));
    extrema[2] = within(third);
    for (int i = 0; i < 3; ++i)
    {
      const Lanes s = extrema[i];
      at[i] = ((s * s + g2) * s + g1) * s + g0;
    }
    const Lanes least = Min(Min(Abs(at[0]), Abs(at[1])), Abs(at[2]));
    // The extrema are in order if b <= 2 a, because b is not below a / 2.
    certain = And(b <= a + a, Splat(0x1p17) * (rest * rest) < least * least * least);
  }
};

/// An interval [`low`, `high`] with one root of f and no extremum except `extremum`, which is one
/// of the ends.
struct Bracket
{
  Lanes low;
  Lanes high;
  Lanes extremum;
  Lanes value; ///< f(extremum)
};

/// The root next to an extremum, above or below it.
HWY_INLINE Pair RootIn(
  const Pair (&f)[5], const Bracket& bracket, bool above, LaneMask wanted, LaneMask& failed)
{
  const Lanes zero = Splat(0.0);
  const Lanes g3 = f[3].high;
  const Lanes g2 = f[2].high;
  const Lanes g1 = f[1].high;
  const Lanes g0 = f[0].high;
  const Lanes curvature = Splat(6.0) * (bracket.extremum * bracket.extremum) + g2;
  const Lanes away = Sqrt((zero - bracket.value) / curvature);
  Lanes s = above ? bracket.extremum + away : bracket.extremum - away;
  s = Select(And(bracket.low < s, s < bracket.high), s, (bracket.low + bracket.high) * Splat(0.5));
  // Halley's steps: each step cubes the error.
  LaneMask open = wanted;
  for (int step = 0; step < 6 && !None(open); ++step)
  {
    const Lanes b3 = s + g3;
    const Lanes b2 = b3 * s + g2;
    const Lanes b1 = b2 * s + g1;
    const Lanes value = b1 * s + g0;
    const Lanes d3 = s + b3;
    const Lanes d2 = d3 * s + b2;
    const Lanes slope = d2 * s + b1;
    const Lanes bend = (s + d3) * s + d2;
    const Lanes change = value * slope / (slope * slope - value * bend);
    s = Select(open, s - change, s);
    open = AndNot(open, Abs(change) <= Splat(0x1p-18));
  }
  return PolishedNear(f, s, bracket.low, bracket.high, wanted, failed);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
