// SPDX-License-Identifier: BSD-3-Clause
// A number type that holds twice as many floats as Lanes holds doubles, with the operations of
// a modal sum, and conversions from and to doubles. Included once per instruction set.
#if defined(PIXELEXACT_FLOAT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_FLOAT_LANES_INL_H
#undef PIXELEXACT_FLOAT_LANES_INL_H
#else
#define PIXELEXACT_FLOAT_LANES_INL_H
#endif

#include "Core/Math/TwoLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
#if HWY_TARGET == HWY_SCALAR
using FloatTag = hwy::HWY_NAMESPACE::ScalableTag<float>;
#else
using FloatTag = hwy::HWY_NAMESPACE::Repartition<float, LaneTag>;
#endif
using FloatLanes = Pack<FloatTag>;

template <>
struct NumberTraits<FloatLanes>
{
  /// The type of the recurrences' constants, which the compiler rounds to float.
  using Scalar = double;
  static HWY_INLINE FloatLanes Splat(float value)
  {
    return { hwy::HWY_NAMESPACE::Set(FloatTag(), value) };
  }
  static HWY_INLINE FloatLanes Splat(double value) { return Splat(static_cast<float>(value)); }
  static HWY_INLINE FloatLanes SplatScalar(double value) { return Splat(value); }
};

/// The same as for doubles, with a larger region about the vertex, for the precision of floats.
HWY_INLINE FloatLanes CollapsedQuotient(FloatLanes y, FloatLanes t)
{
  namespace hn = hwy::HWY_NAMESPACE;
  const FloatTag tag;
  const auto regular = hn::Ge(hn::Abs(t.v), hn::Set(tag, 1e-4F));
  const auto one = hn::Set(tag, 1.0F);
  const auto vanishing = hn::Eq(t.v, hn::Zero(tag));
  const auto quotient =
    hn::IfThenElseZero(hn::Not(vanishing), hn::Div(y.v, hn::IfThenElse(vanishing, one, t.v)));
  return { hn::IfThenElse(regular, quotient, hn::Max(hn::Min(quotient, one), hn::Neg(one))) };
}
/// Used as a divisor of derivatives alone.
HWY_INLINE FloatLanes SafeReciprocal(FloatLanes t)
{
  namespace hn = hwy::HWY_NAMESPACE;
  return { hn::Div(hn::Set(FloatTag(), 1.0F), t.v) };
}

/// The number of packs of doubles that fill a pack of floats: two, or one without lanes.
#if HWY_TARGET == HWY_SCALAR
inline constexpr int kPacksOfFloats = 1;
HWY_INLINE FloatLanes ToFloat(Lanes low, Lanes /*high*/)
{
  return { hwy::HWY_NAMESPACE::DemoteTo(FloatTag(), low.v) };
}
HWY_INLINE TwoLanes ToDouble(FloatLanes a)
{
  const Lanes low{ hwy::HWY_NAMESPACE::PromoteTo(LaneTag(), a.v) };
  return { low, low };
}
#else
inline constexpr int kPacksOfFloats = 2;
HWY_INLINE FloatLanes ToFloat(Lanes low, Lanes high)
{
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::Half<FloatTag> half;
  return { hn::Combine(FloatTag(), hn::DemoteTo(half, high.v), hn::DemoteTo(half, low.v)) };
}
HWY_INLINE TwoLanes ToDouble(FloatLanes a)
{
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::Half<FloatTag> half;
  return { { hn::PromoteTo(LaneTag(), hn::LowerHalf(half, a.v)) },
    { hn::PromoteTo(LaneTag(), hn::UpperHalf(half, a.v)) } };
}
#endif

HWY_INLINE void StoreAsFloats(Lanes a, float* to)
{
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::Rebind<float, LaneTag> tag;
  hn::StoreU(hn::DemoteTo(tag, a.v), tag, to);
}

using TwoFloats = Two<FloatLanes>;
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
