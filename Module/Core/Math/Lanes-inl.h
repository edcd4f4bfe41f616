// SPDX-License-Identifier: BSD-3-Clause
// The number type `Lanes` holds as many doubles as the instruction set allows, with the operations
// that the kernels' templates use. Other code reaches Highway's vectors through it.
// Included once per instruction set, hence the toggling guard (Highway's convention).
#if defined(PIXELEXACT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_LANES_INL_H
#undef PIXELEXACT_LANES_INL_H
#else
#define PIXELEXACT_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

/// Compiles a lambda for the instruction set at hand and inlines it into its caller, so that its
/// captures stay in registers. Builds with few orders do not inline, to save compile time.
#ifndef PIXELEXACT_INLINED
#ifdef PIXELEXACT_FEW_ORDERS
#define PIXELEXACT_INLINED HWY_ATTR
#else
#define PIXELEXACT_INLINED HWY_ATTR __attribute__((always_inline))
#endif
#endif

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using LaneTag = hwy::HWY_NAMESPACE::ScalableTag<double>;
using LaneVector = hwy::HWY_NAMESPACE::Vec<LaneTag>;
using LaneMask = hwy::HWY_NAMESPACE::Mask<LaneTag>;

HWY_INLINE int LaneCount()
{
  return static_cast<int>(hwy::HWY_NAMESPACE::Lanes(LaneTag()));
}

/// A pack of numbers with the arithmetic of one.
template <class Tag>
struct Pack
{
  hwy::HWY_NAMESPACE::Vec<Tag> v;
};
using Lanes = Pack<LaneTag>;

template <class Tag>
HWY_INLINE Pack<Tag> operator+(Pack<Tag> a, Pack<Tag> b)
{
  return { hwy::HWY_NAMESPACE::Add(a.v, b.v) };
}
template <class Tag>
HWY_INLINE Pack<Tag> operator-(Pack<Tag> a, Pack<Tag> b)
{
  return { hwy::HWY_NAMESPACE::Sub(a.v, b.v) };
}
template <class Tag>
HWY_INLINE Pack<Tag> operator*(Pack<Tag> a, Pack<Tag> b)
{
  return { hwy::HWY_NAMESPACE::Mul(a.v, b.v) };
}
HWY_INLINE Lanes operator/(Lanes a, Lanes b)
{
  return { hwy::HWY_NAMESPACE::Div(a.v, b.v) };
}
template <class Tag>
HWY_INLINE Pack<Tag> MulAdd(Pack<Tag> a, Pack<Tag> b, Pack<Tag> c)
{
  return { hwy::HWY_NAMESPACE::MulAdd(a.v, b.v, c.v) };
}
/// a b - c
HWY_INLINE Lanes MulSub(Lanes a, Lanes b, Lanes c)
{
  return { hwy::HWY_NAMESPACE::MulSub(a.v, b.v, c.v) };
}
/// c - a b
template <class Tag>
HWY_INLINE Pack<Tag> NegMulAdd(Pack<Tag> a, Pack<Tag> b, Pack<Tag> c)
{
  return { hwy::HWY_NAMESPACE::NegMulAdd(a.v, b.v, c.v) };
}
HWY_INLINE Lanes Min(Lanes a, Lanes b)
{
  return { hwy::HWY_NAMESPACE::Min(a.v, b.v) };
}
HWY_INLINE Lanes Max(Lanes a, Lanes b)
{
  return { hwy::HWY_NAMESPACE::Max(a.v, b.v) };
}
HWY_INLINE Lanes Abs(Lanes a)
{
  return { hwy::HWY_NAMESPACE::Abs(a.v) };
}
HWY_INLINE Lanes Sqrt(Lanes a)
{
  return { hwy::HWY_NAMESPACE::Sqrt(a.v) };
}
HWY_INLINE LaneMask operator<(Lanes a, Lanes b)
{
  return hwy::HWY_NAMESPACE::Lt(a.v, b.v);
}
HWY_INLINE LaneMask operator<=(Lanes a, Lanes b)
{
  return hwy::HWY_NAMESPACE::Le(a.v, b.v);
}
HWY_INLINE LaneMask operator>=(Lanes a, Lanes b)
{
  return hwy::HWY_NAMESPACE::Ge(a.v, b.v);
}
HWY_INLINE Lanes Select(LaneMask mask, Lanes yes, Lanes no)
{
  return { hwy::HWY_NAMESPACE::IfThenElse(mask, yes.v, no.v) };
}
HWY_INLINE LaneMask And(LaneMask a, LaneMask b)
{
  return hwy::HWY_NAMESPACE::And(a, b);
}
HWY_INLINE LaneMask Or(LaneMask a, LaneMask b)
{
  return hwy::HWY_NAMESPACE::Or(a, b);
}
/// a and not b
HWY_INLINE LaneMask AndNot(LaneMask a, LaneMask b)
{
  return hwy::HWY_NAMESPACE::AndNot(b, a);
}
HWY_INLINE bool None(LaneMask mask)
{
  return hwy::HWY_NAMESPACE::AllFalse(LaneTag(), mask);
}
HWY_INLINE bool All(LaneMask mask)
{
  return hwy::HWY_NAMESPACE::AllTrue(LaneTag(), mask);
}
/// False for NaN.
HWY_INLINE LaneMask IsFinite(Lanes a)
{
  return hwy::HWY_NAMESPACE::Le(hwy::HWY_NAMESPACE::Abs(a.v),
    hwy::HWY_NAMESPACE::Set(LaneTag(), std::numeric_limits<double>::max()));
}
HWY_INLINE void Store(Lanes a, double* to)
{
  hwy::HWY_NAMESPACE::StoreU(a.v, LaneTag(), to);
}

/// One bit per lane, the first lane in the lowest.
HWY_INLINE std::uint64_t BitsOf(LaneMask mask)
{
  std::uint8_t bytes[8] = {};
  hwy::HWY_NAMESPACE::StoreMaskBits(LaneTag(), mask, bytes);
  return bytes[0];
}

/// test(i) for each pack with a point in `bits`; returns the bits that passed.
template <class Test>
HWY_INLINE std::uint64_t ForEachPackIn(std::uint64_t bits, Test&& test)
{
  const int lanes = LaneCount();
  const std::uint64_t pack = (std::uint64_t{ 1 } << static_cast<unsigned>(lanes)) - 1U;
  std::uint64_t result = 0;
  for (std::uint64_t left = bits; left != 0;)
  {
    const int i = std::countr_zero(left) / lanes * lanes;
    left &= ~(pack << static_cast<unsigned>(i));
    result |= BitsOf(test(i)) << static_cast<unsigned>(i);
  }
  return result & bits;
}
HWY_INLINE LaneMask MaskOf(std::uint64_t bits)
{
  const std::uint8_t bytes[8] = { static_cast<std::uint8_t>(bits) };
  return hwy::HWY_NAMESPACE::LoadMaskBits(LaneTag(), bytes);
}
/// Moves the lanes of a set to the front, in order; the lanes after them are undefined. Highway's
/// Compress copies its table at every call (1.0.3), and storing through a mask is microcode on some
/// processors.
class LanesToFront
{
public:
  HWY_INLINE explicit LanesToFront(std::uint64_t bits)
    : Number(hwy::HWY_NAMESPACE::LoadU(NumberTag(), kOrders[bits].data()))
  {
  }

  HWY_INLINE Lanes operator()(Lanes a) const
  {
    const hwy::HWY_NAMESPACE::RebindToSigned<LaneTag> whole;
    return { hwy::HWY_NAMESPACE::TableLookupLanes(a.v,
      hwy::HWY_NAMESPACE::IndicesFromVec(
        LaneTag(), hwy::HWY_NAMESPACE::PromoteTo(whole, Number))) };
  }
  /// Stores first + the number of each; a whole pack is written.
  HWY_INLINE void StoreNumbers(int first, int* to) const
  {
    hwy::HWY_NAMESPACE::StoreU(
      hwy::HWY_NAMESPACE::Add(Number, hwy::HWY_NAMESPACE::Set(NumberTag(), first)), NumberTag(),
      to);
  }

private:
  using NumberTag = hwy::HWY_NAMESPACE::Rebind<std::int32_t, LaneTag>;
  static constexpr std::size_t kMaxLanes = 8;
  using Orders = std::array<std::array<std::int32_t, kMaxLanes>, 1U << kMaxLanes>;
  /// For each set of lanes their numbers, in order, followed by zeros.
  static constexpr Orders kOrders = []
  {
    Orders orders{};
    for (std::size_t set = 0; set < orders.size(); ++set)
    {
      std::size_t count = 0;
      for (std::size_t lane = 0; lane < kMaxLanes; ++lane)
      {
        if ((set >> lane & 1U) != 0)
        {
          orders[set][count++] = static_cast<std::int32_t>(lane);
        }
      }
    }
    return orders;
  }();

  hwy::HWY_NAMESPACE::Vec<NumberTag> Number;
};
/// first, first + 1, ...: as many as there are lanes.
HWY_INLINE void StoreNumbers(int first, int* to)
{
  const hwy::HWY_NAMESPACE::Rebind<std::int32_t, LaneTag> tag;
  hwy::HWY_NAMESPACE::StoreU(hwy::HWY_NAMESPACE::Iota(tag, first), tag, to);
}
HWY_INLINE double Least(Lanes a)
{
  return hwy::HWY_NAMESPACE::GetLane(hwy::HWY_NAMESPACE::MinOfLanes(LaneTag(), a.v));
}
HWY_INLINE double Most(Lanes a)
{
  return hwy::HWY_NAMESPACE::GetLane(hwy::HWY_NAMESPACE::MaxOfLanes(LaneTag(), a.v));
}

/// The operations that the evaluation templates need from their number type. Scalar is the type of
/// the recurrences' constants.
template <class T>
struct NumberTraits
{
  using Scalar = T;
  static HWY_INLINE T Splat(double value) { return static_cast<T>(value); }
  static HWY_INLINE T SplatScalar(T value) { return value; }
};
template <>
struct NumberTraits<Lanes>
{
  using Scalar = double;
  using Mask = LaneMask;
  static HWY_INLINE int Count() { return LaneCount(); }
  static HWY_INLINE Lanes Load(const double* from)
  {
    return { hwy::HWY_NAMESPACE::LoadU(LaneTag(), from) };
  }
  static HWY_INLINE Lanes Splat(double value)
  {
    return { hwy::HWY_NAMESPACE::Set(LaneTag(), value) };
  }
  static HWY_INLINE Lanes SplatScalar(double value) { return Splat(value); }
};

HWY_INLINE long double MulAdd(long double a, long double b, long double c)
{
  return a * b + c;
}
HWY_INLINE long double NegMulAdd(long double a, long double b, long double c)
{
  return c - a * b;
}
/// The quotient y / t of collapsed coordinates, kept finite at the collapsed vertex (t = 0), where
/// y is of t's size.
HWY_INLINE long double CollapsedQuotient(long double y, long double t)
{
  if (t > 1e-8L || t < -1e-8L)
  {
    return y / t;
  }
  const long double quotient = t != 0.0L ? y / t : 0.0L;
  return quotient < -1.0L ? -1.0L : (quotient > 1.0L ? 1.0L : quotient);
}
HWY_INLINE Lanes CollapsedQuotient(Lanes y, Lanes t)
{
  using Traits = NumberTraits<Lanes>;
  const Lanes zero = Traits::Splat(0.0);
  const Lanes one = Traits::Splat(1.0);
  const LaneMask regular = Abs(t) >= Traits::Splat(1e-8);
  const LaneMask vanishing = Abs(t) <= zero;
  const Lanes quotient = Select(vanishing, zero, y / Select(vanishing, one, t));
  return Select(regular, quotient, Max(Min(quotient, one), zero - one));
}
HWY_INLINE long double SafeReciprocal(long double t)
{
  return 1.0L / (t > 1e-30L || t < -1e-30L ? t : 1e-30L);
}
HWY_INLINE Lanes SafeReciprocal(Lanes t)
{
  using Traits = NumberTraits<Lanes>;
  const Lanes tiny = Traits::Splat(1e-30);
  return Traits::Splat(1.0) / Select(Abs(t) < tiny, tiny, t);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
