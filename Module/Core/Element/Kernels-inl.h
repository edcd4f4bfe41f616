// SPDX-License-Identifier: BSD-3-Clause
// The batch kernels as templates on a shape's Modes class and its order; see Kernels.h.
#if defined(PIXELEXACT_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_KERNELS_INL_H
#undef PIXELEXACT_KERNELS_INL_H
#else
#define PIXELEXACT_KERNELS_INL_H
#endif

#include "Core/Basis/Modes-inl.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/Overflow-inl.h"
#include "Core/Element/Preimage-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// run(pack, i) for the packs that make up PaddedCount(count) points: two at a time while there
/// are, then one. `pack` is a number of the type to use.
template <class Run>
HWY_INLINE void ForEachPack(int count, Run&& run)
{
  const int lanes = LaneCount();
  int i = 0;
  for (; i + lanes < count && i + 2 * lanes <= PaddedCount(count); i += 2 * lanes)
  {
    run(TwoLanes(), i);
  }
  for (; i < count; i += lanes)
  {
    run(Lanes(), i);
  }
}

template <template <class, class, bool> class Modes, class Order>
void ValueKernel(const Space& space, const double* coefficients, int components,
  const LanePoints& xi, double* const* out)
{
  const int modeCount = components > 1 ? space.Modes() : 0;
  ForEachPack(xi.count,
    [&](auto pack, int i) PIXELEXACT_INLINED
    {
      using T = decltype(pack);
      const Point<T> at = LoadPoint<T>(xi, i);
      const Modes<T, Order, false> modes(space, at);
      for (int c = 0; c < components; ++c)
      {
        const double* component = coefficients + static_cast<std::ptrdiff_t>(c) * modeCount;
        T value = modes.Value(component);
        if (HWY_UNLIKELY(!All(IsFinite(value))))
        {
          RescueValue<Modes>(space, component, at, value);
        }
        Store(value, out[c] + i);
      }
    });
}

template <template <class, class, bool> class Modes, class Order>
void GradientKernel(const Space& space, const double* coefficients, int components,
  const LanePoints& xi, double* const* out, double* const* gradient)
{
  const int modeCount = components > 1 ? space.Modes() : 0;
  const int lanes = LaneCount();
  for (int i = 0; i < xi.count; i += lanes)
  {
    const Point<Lanes> at = LoadPoint<Lanes>(xi, i);
    const Modes<Lanes, Order, true> modes(space, at);
    for (int c = 0; c < components; ++c)
    {
      const double* component = coefficients + static_cast<std::ptrdiff_t>(c) * modeCount;
      auto e = modes.Evaluate(component);
      const LaneMask finite = IsFinite(e.value + e.gradient[0] + e.gradient[1] + e.gradient[2]);
      if (HWY_UNLIKELY(!All(finite)))
      {
        RescueGradient<Modes>(space, component, at, finite, e);
      }
      Store(e.value, out[c] + i);
      for (int d = 0; d < 3; ++d)
      {
        Store(e.gradient[d], gradient[3 * c + d] + i);
      }
    }
  }
}

template <template <class, class, bool> class Modes, class Order>
void InvertKernel(const InverseProblem& problem, const LanePoints& x, const InverseResult& out)
{
  const int modeCount = problem.space.Modes();
  for (int i = 0; i < x.count; i += LaneCount())
  {
    InvertPack<Modes, Order, Lanes>(problem, modeCount, x, out, i);
  }
}

/// Gradients and inverse maps of higher orders are rarer than the time to compile them is worth.
inline constexpr int kMaxFixedMapOrder = 4;

/// The largest order that is compiled in: none for processors without AVX2, which are from before
/// 2013; few where the build is not made for speed.
#if HWY_TARGET == HWY_SCALAR || (defined(HWY_SSE2) && HWY_TARGET == HWY_SSE2)
inline constexpr int kMaxFixedOrder = -1;
#elif defined(PIXELEXACT_FEW_ORDERS)
inline constexpr int kMaxFixedOrder = 1;
#else
inline constexpr int kMaxFixedOrder = kMaxOrder;
#endif

/// set(Const<P>()) where `order` is P, one of the list, and compiled in.
template <int... kOrders, class Set>
void ForOrder(int order, const Set& set)
{
  const auto setIf = [&]<int P>(Const<P> one)
  {
    if constexpr (P <= kMaxFixedOrder)
    {
      if (order == P)
      {
        set(one);
      }
    }
  };
  (setIf(Const<kOrders>()), ...);
}

/// The same for a space that has one order in all directions.
template <int... kOrders, class Set>
void ForFixedOrder(const Space& space, const Set& set)
{
  const auto [p, q, r] = space.order;
  if (p == q && q == r)
  {
    ForOrder<kOrders...>(p, set);
  }
}

/// Kernels with the order compiled in for the usual uniform orders, generic ones above.
template <template <class, class, bool> class Modes, int... kOrders>
KernelSet SelectKernelSet(const Space& space)
{
  KernelSet set;
  set.value = &ValueKernel<Modes, AnyOrder>;
  set.gradient = &GradientKernel<Modes, AnyOrder>;
  set.invert = &InvertKernel<Modes, AnyOrder>;
  ForFixedOrder<kOrders...>(space,
    [&]<int P>(Const<P> /*order*/)
    {
      set.value = &ValueKernel<Modes, FixedOrder<P>>;
      if constexpr (P <= kMaxFixedMapOrder)
      {
        set.gradient = &GradientKernel<Modes, FixedOrder<P>>;
        set.invert = &InvertKernel<Modes, FixedOrder<P>>;
      }
    });
  constexpr Shape kShape = Modes<Lanes, AnyOrder, false>::kShape;
  if constexpr (kShape == Shape::Hexahedron || kShape == Shape::Prism)
  {
    const auto [p, q, r] = space.order;
    if (q == 0 && p == r)
    {
      ForOrder<1, 2, 3, 4>(p,
        [&]<int P>(Const<P> /*order*/)
        { set.gradient = &GradientKernel<Modes, FixedFaceOrder<P>>; });
    }
  }
  return set;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
