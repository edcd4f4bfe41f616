// SPDX-License-Identifier: BSD-3-Clause
// Rays about their point closest to a centre, in pairs of doubles: the distant origin is subtracted
// before coordinates are squared. Included once per instruction set.
//
// Only operations that are exact with and without contraction are contracted, so that all
// instruction sets give the same bits.
#if defined(PIXELEXACT_PAIR_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PAIR_RAY_INL_H
#undef PIXELEXACT_PAIR_RAY_INL_H
#else
#define PIXELEXACT_PAIR_RAY_INL_H
#endif

#include "Core/Element/Matrix-inl.h"
#include "Trace/Rays.h"
#include "Trace/Surfaces/HitSlots.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Sums and products are rounded one by one, so that all instruction sets give the same bits.
HWY_INLINE Lanes PlainDot(const Lanes (&a)[3], const Lanes (&b)[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a + b, exactly unless a's exponent is the smaller one.
HWY_INLINE Pair FastSum(Lanes a, Lanes b)
{
  const Lanes sum = a + b;
  return { sum, b - (sum - a) };
}

/// A sum whose rounding errors are summed separately. n terms have an error of 2 n u^2 of the sum
/// of their magnitudes (T. Ogita, S. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci.
/// Comput. 26, 2005).
struct PairSum
{
  Lanes high;
  Lanes low;

  HWY_INLINE void Add(const Pair& term)
  {
    const Pair sum = ExactSum(high, term.high);
    high = sum.high;
    low = low + (sum.low + term.low);
  }
  [[nodiscard]] HWY_INLINE Pair Get() const { return FastSum(high, low); }
};

/// a b, not normalised: a term of a sum.
HWY_INLINE Pair Term(Lanes a, Lanes b)
{
  return ExactProduct(a, b);
}
HWY_INLINE Pair Term(const Pair& a, Lanes b)
{
  const Pair product = ExactProduct(a.high, b);
  return { product.high, product.low + a.low * b };
}
HWY_INLINE Pair Term(const Pair& a, const Pair& b)
{
  const Pair product = ExactProduct(a.high, b.high);
  return { product.high, product.low + (a.high * b.low + a.low * b.high) };
}

/// a.b without its last addition.
template <class A, class B>
HWY_INLINE PairSum SumOfTerms(const A (&a)[3], const B (&b)[3])
{
  const Pair term = Term(a[0], b[0]);
  PairSum sum{ term.high, term.low };
  sum.Add(Term(a[1], b[1]));
  sum.Add(Term(a[2], b[2]));
  return sum;
}
template <class A, class B>
HWY_INLINE Pair PairDot(const A (&a)[3], const B (&b)[3])
{
  return SumOfTerms(a, b).Get();
}

HWY_INLINE Pair Negative(const Pair& a)
{
  const Lanes zero = Splat(0.0);
  return { zero - a.high, zero - a.low };
}
HWY_INLINE Pair Plus(const Pair& a, const Pair& b)
{
  const Pair sum = ExactSum(a.high, b.high);
  return FastSum(sum.high, sum.low + (a.low + b.low));
}
HWY_INLINE Pair Times(const Pair& a, const Pair& b)
{
  const Pair product = Term(a, b);
  return FastSum(product.high, product.low);
}
/// a / b; its low part is only nearly normalised. `reciprocal`: 1 / b, rounded.
HWY_INLINE Pair Over(const Pair& a, const Pair& b, Lanes reciprocal)
{
  const Lanes high = a.high * reciprocal;
  const Pair product = ExactProduct(high, b.high);
  const Lanes rest = ((a.high - product.high) - product.low) + (a.low - high * b.low);
  return { high, rest * reciprocal };
}
/// The square root of a >= 0.
HWY_INLINE Pair SquareRoot(const Pair& a)
{
  const Lanes high = Sqrt(a.high);
  const Pair square = ExactProduct(high, high);
  const Lanes rest = ((a.high - square.high) - square.low) + a.low;
  const Lanes low = rest / (high + high);
  const Lanes zero = Splat(0.0);
  return { high, Select(zero < high, low, zero) };
}

/// x(t0 + s) = centre + p + s d, where s = 0 is nearly closest to the centre.
struct PairRay
{
  Lanes t0;
  Pair p[3];
  Lanes d[3];
  Pair squaredLength; ///< d.d

  /// The ray about t0 = `middle`, which need not be exact: p contains the difference.
  HWY_INLINE PairRay(const RayLanes& rays, int at, const Lanes (&centre)[3], Lanes middle)
    : t0(middle)
  {
    using Traits = NumberTraits<Lanes>;
    ForEachAxis(
      [&](auto i) PIXELEXACT_INLINED
      {
        d[i] = Traits::Load(rays.direction[i] + at);
        const Pair from = ExactSum(Traits::Load(rays.origin[i] + at), Splat(0.0) - centre[i]);
        const Pair moved = ExactProduct(t0, d[i]);
        const Pair sum = ExactSum(from.high, moved.high);
        p[i] = FastSum(sum.high, sum.low + (from.low + moved.low));
      });
    squaredLength = PairDot(d, d);
  }

  /// t0 + s, rounded once.
  [[nodiscard]] HWY_INLINE Lanes TimeAt(const Pair& s) const
  {
    const Pair sum = ExactSum(t0, s.high);
    return sum.high + (sum.low + s.low);
  }

  /// centre + p
  HWY_INLINE void Middle(const Lanes (&centre)[3], Pair (&middle)[3]) const
  {
    ForEachAxis(
      [&](auto i) PIXELEXACT_INLINED
      {
        const Pair sum = ExactSum(centre[i], p[i].high);
        middle[i] = { sum.high, sum.low + p[i].low };
      });
  }

  /// x(t0 + s) from the middle; each coordinate is rounded once.
  HWY_INLINE void PositionAt(const Pair (&middle)[3], const Pair& s, Lanes (&position)[3]) const
  {
    ForEachAxis(
      [&](auto i) PIXELEXACT_INLINED
      {
        const Pair moved = Term(s, d[i]);
        const Pair x = ExactSum(middle[i].high, moved.high);
        position[i] = x.high + (x.low + (middle[i].low + moved.low));
      });
  }
  HWY_INLINE void PutPosition(
    const Pair (&middle)[3], const Pair& s, double* const to[3], int at) const
  {
    Lanes position[3];
    PositionAt(middle, s, position);
    ForEachAxis([&](auto i) PIXELEXACT_INLINED { Store(position[i], to[i] + at); });
  }
};

/// The lanes that hold rays, of the pack that begins with ray `at`.
HWY_INLINE LaneMask RaysOfPack(int at, int count)
{
  return hwy::HWY_NAMESPACE::FirstN(LaneTag(), static_cast<std::size_t>(count - at));
}

/// The t between the rays' ends; NaN and infinite t are not.
HWY_INLINE LaneMask WithinEnds(const RayLanes& rays, int at, Lanes t)
{
  using Traits = NumberTraits<Lanes>;
  const Lanes far = Min(Traits::Load(rays.tFar + at), Splat(std::numeric_limits<double>::max()));
  return And(Traits::Load(rays.tNear + at) <= t, t <= far);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
