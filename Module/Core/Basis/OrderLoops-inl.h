// SPDX-License-Identifier: BSD-3-Clause
// The orders of a space as numbers known at compile time or at run time, and loops over them. With
// the former the loops over modes are unrolled, tables live in registers, and sums cost what their
// multiply-adds do.
#if defined(PIXELEXACT_ORDER_LOOPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_ORDER_LOOPS_INL_H
#undef PIXELEXACT_ORDER_LOOPS_INL_H
#else
#define PIXELEXACT_ORDER_LOOPS_INL_H
#endif

#include "Core/Basis/Space.h"
#include "Core/Math/Lanes-inl.h"

#include <algorithm>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// An int that is part of its type.
template <int N>
struct Const
{
  constexpr operator int() const { return N; }
};
template <int A, int B>
constexpr Const<A + B> operator+(Const<A> /*a*/, Const<B> /*b*/)
{
  return {};
}
template <int A, int B>
constexpr Const<A - B> operator-(Const<A> /*a*/, Const<B> /*b*/)
{
  return {};
}
template <int A, int B>
constexpr Const<std::max(A, B)> Larger(Const<A> /*a*/, Const<B> /*b*/)
{
  return {};
}
constexpr int Larger(int a, int b)
{
  return std::max(a, b);
}

template <class Visit, int... k>
HWY_INLINE void VisitEach(Visit& visit, std::integer_sequence<int, k...> /*indices*/)
{
  (visit(Const<k>()), ...);
}

/// visit(i) for i = 0 .. last: unrolled, with i a Const, where last is one.
template <int kLast, class Visit>
HWY_INLINE void ForEachUpTo(Const<kLast> /*last*/, Visit&& visit)
{
  VisitEach(visit, std::make_integer_sequence<int, (kLast < 0 ? 0 : kLast + 1)>());
}
template <class Visit>
HWY_INLINE void ForEachUpTo(int last, Visit&& visit)
{
  for (int i = 0; i <= last; ++i)
  {
    visit(i);
  }
}

/// The same for outer loops, which are unrolled only where that is little code.
template <int kLast, class Visit>
HWY_INLINE void ForEachOuterUpTo(Const<kLast> last, Visit&& visit)
{
  if constexpr (kLast <= 3)
  {
    ForEachUpTo(last, visit);
  }
  else
  {
    ForEachUpTo(static_cast<int>(last), visit);
  }
}
template <class Visit>
HWY_INLINE void ForEachOuterUpTo(int last, Visit&& visit)
{
  ForEachUpTo(last, visit);
}

/// visit(d) for d = 0, 1, 2, unrolled: arrays that are indexed by d stay in registers.
template <class Visit>
HWY_INLINE void ForEachAxis(Visit&& visit)
{
  ForEachUpTo(Const<2>(), visit);
}

/// The orders of a uniform space, known at compile time.
template <int P>
struct FixedOrder
{
  static constexpr int kCapacity = P + 1;
  explicit FixedOrder(const Space& /*space*/) {}
  static constexpr Const<P> p() { return {}; }
  static constexpr Const<P> q() { return {}; }
  static constexpr Const<P> r() { return {}; }
};

/// The same for a face's space, a hexahedron's or a prism's without order along xi2.
template <int P>
struct FixedFaceOrder
{
  static constexpr int kCapacity = P + 1;
  explicit FixedFaceOrder(const Space& /*space*/) {}
  static constexpr Const<P> p() { return {}; }
  static constexpr Const<0> q() { return {}; }
  static constexpr Const<P> r() { return {}; }
};

/// Orders known at run time.
struct AnyOrder
{
  static constexpr int kCapacity = kMaxOrder + 1;
  explicit AnyOrder(const Space& space)
    : order(space.order)
  {
  }
  [[nodiscard]] int p() const { return order[0]; }
  [[nodiscard]] int q() const { return order[1]; }
  [[nodiscard]] int r() const { return order[2]; }
  std::array<std::uint8_t, 3> order;
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
