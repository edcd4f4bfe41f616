// SPDX-License-Identifier: BSD-3-Clause
// Two packs as one number: independent work that fills the processor's pipelines while a
// sum waits for its last term, and coefficients that are loaded once for both. Every operation is
// that of one pack, so a point's result is the same, bit for bit, in either. Included once per
// instruction set.
#if defined(PIXELEXACT_TWO_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_TWO_LANES_INL_H
#undef PIXELEXACT_TWO_LANES_INL_H
#else
#define PIXELEXACT_TWO_LANES_INL_H
#endif

#include "Core/Math/Lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
// Members and not an array: compilers keep these in registers.
template <class T>
struct Two
{
  T low;
  T high;
};
using TwoLanes = Two<Lanes>;

struct TwoMasks
{
  LaneMask low;
  LaneMask high;
};

template <class T>
HWY_INLINE Two<T> operator+(Two<T> a, Two<T> b)
{
  return { a.low + b.low, a.high + b.high };
}
template <class T>
HWY_INLINE Two<T> operator-(Two<T> a, Two<T> b)
{
  return { a.low - b.low, a.high - b.high };
}
template <class T>
HWY_INLINE Two<T> operator*(Two<T> a, Two<T> b)
{
  return { a.low * b.low, a.high * b.high };
}
template <class T>
HWY_INLINE Two<T> MulAdd(Two<T> a, Two<T> b, Two<T> c)
{
  return { MulAdd(a.low, b.low, c.low), MulAdd(a.high, b.high, c.high) };
}
template <class T>
HWY_INLINE Two<T> NegMulAdd(Two<T> a, Two<T> b, Two<T> c)
{
  return { NegMulAdd(a.low, b.low, c.low), NegMulAdd(a.high, b.high, c.high) };
}
template <class T>
HWY_INLINE Two<T> CollapsedQuotient(Two<T> y, Two<T> t)
{
  return { CollapsedQuotient(y.low, t.low), CollapsedQuotient(y.high, t.high) };
}
template <class T>
HWY_INLINE Two<T> SafeReciprocal(Two<T> t)
{
  return { SafeReciprocal(t.low), SafeReciprocal(t.high) };
}
HWY_INLINE TwoLanes Select(TwoMasks mask, TwoLanes yes, TwoLanes no)
{
  return { Select(mask.low, yes.low, no.low), Select(mask.high, yes.high, no.high) };
}
HWY_INLINE bool All(TwoMasks mask)
{
  return All(And(mask.low, mask.high));
}
HWY_INLINE TwoMasks IsFinite(TwoLanes a)
{
  return { IsFinite(a.low), IsFinite(a.high) };
}
HWY_INLINE void Store(TwoLanes a, double* to)
{
  Store(a.low, to);
  Store(a.high, to + LaneCount());
}

template <class T>
struct NumberTraits<Two<T>>
{
  using Scalar = double;
  template <class Value>
  static HWY_INLINE Two<T> Splat(Value value)
  {
    const T lanes = NumberTraits<T>::Splat(value);
    return { lanes, lanes };
  }
  static HWY_INLINE Two<T> SplatScalar(double value) { return Splat(value); }
  static HWY_INLINE Two<T> Load(const double* from)
  {
    return { NumberTraits<T>::Load(from), NumberTraits<T>::Load(from + NumberTraits<T>::Count()) };
  }
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
