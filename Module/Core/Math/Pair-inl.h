// SPDX-License-Identifier: BSD-3-Clause
// Sums of two doubles in lanes, as a number type of about 104 bits; its only purpose are tables of
// polynomials whose recurrences would magnify the rounding of single doubles. Included once per
// instruction set.
//
// Error bounds, with u = 2^-53 and without underflow: a product is off by at most 9 u^2 |x y| (u^2
// for the neglected product of the lows, 2 u^2 for the rounding of two cross products, 6 u^2 for
// that of two sums), a sum or difference by 4 u^2 (|x| + |y|), also under cancellation (2 u^2 for
// the sum of the lows and as much for its addition to the highs' rounding error). Operands are
// normalised: |low| <= u |high|. See M. Joldes, J.-M. Muller and V. Popescu, Tight and rigorous
// error bounds for basic building blocks of double-word arithmetic, ACM TOMS 44, 2017. Contraction
// of products and sums by the compiler would void this; the library is built without.
#if defined(PIXELEXACT_PAIR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PAIR_INL_H
#undef PIXELEXACT_PAIR_INL_H
#else
#define PIXELEXACT_PAIR_INL_H
#endif

#include "Core/Math/DoublePair.h"
#include "Core/Math/Lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
struct Pair
{
  Lanes high;
  Lanes low;

  static HWY_INLINE Pair Of(Lanes value) { return { value, NumberTraits<Lanes>::Splat(0.0) }; }
  static HWY_INLINE Pair Of(const DoublePair& value)
  {
    return { NumberTraits<Lanes>::Splat(value.high), NumberTraits<Lanes>::Splat(value.low) };
  }
};

/// a + b, exactly (D. Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B).
HWY_INLINE Pair ExactSum(Lanes a, Lanes b)
{
  const Lanes sum = a + b;
  const Lanes added = sum - a;
  return { sum, (a - (sum - added)) + (b - added) };
}

#if !HWY_NATIVE_FMA
/// The upper 26 bits (Dekker 1971); below 2^996.
HWY_INLINE Lanes UpperBits(Lanes a)
{
  const Lanes scaled = NumberTraits<Lanes>::Splat(0x1p27 + 1.0) * a;
  return scaled - (scaled - a);
}
#endif

/// a b, exactly unless it underflows.
HWY_INLINE Pair ExactProduct(Lanes a, Lanes b)
{
  const Lanes product = a * b;
#if HWY_NATIVE_FMA
  return { product, MulSub(a, b, product) };
#else
  const Lanes a1 = UpperBits(a);
  const Lanes a2 = a - a1;
  const Lanes b1 = UpperBits(b);
  const Lanes b2 = b - b1;
  return { product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2 };
#endif
}

HWY_INLINE Pair operator+(const Pair& a, const Pair& b)
{
  const Pair sum = ExactSum(a.high, b.high);
  return ExactSum(sum.high, sum.low + (a.low + b.low));
}
HWY_INLINE Pair operator-(const Pair& a, const Pair& b)
{
  const Pair difference = ExactSum(a.high, NumberTraits<Lanes>::Splat(0.0) - b.high);
  return ExactSum(difference.high, difference.low + (a.low - b.low));
}
HWY_INLINE Pair operator*(const Pair& a, const Pair& b)
{
  const Pair product = ExactProduct(a.high, b.high);
  return ExactSum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
