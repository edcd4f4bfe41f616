// SPDX-License-Identifier: BSD-3-Clause
// The values of KernelSet in single precision, as templates on a shape's Modes class and its order;
// see Kernels.h.
#if defined(PIXELEXACT_FLOAT_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_FLOAT_KERNELS_INL_H
#undef PIXELEXACT_FLOAT_KERNELS_INL_H
#else
#define PIXELEXACT_FLOAT_KERNELS_INL_H
#endif

#include "Core/Element/Kernels-inl.h"
#include "Core/Math/FloatLanes-inl.h"

#include <algorithm>
#include <cmath>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Coefficients in single precision, component by component.
struct FloatCoefficients
{
  std::vector<float> values;
  std::vector<double> scales; ///< of each component: what its values are to be multiplied by

  void Round(const double* coefficients, int modes, int components)
  {
    values.resize(static_cast<std::size_t>(modes) * static_cast<std::size_t>(components));
    scales.resize(static_cast<std::size_t>(components));
    float* to = values.data();
    for (double& scale : scales)
    {
      int exponent = 0;
      if (const double largest = Largest(coefficients, modes); std::isfinite(largest))
      {
        std::frexp(largest, &exponent);
      }
      // Keeps both powers of two normal numbers.
      exponent = std::clamp(exponent, -1000, 1000);
      scale = std::ldexp(1.0, exponent);
      const double reciprocal = std::ldexp(1.0, -exponent);
      int k = 0;
      for (; k + LaneCount() <= modes; k += LaneCount())
      {
        StoreAsFloats(NumberTraits<Lanes>::Load(coefficients + k) * Splat(reciprocal), to + k);
      }
      for (; k < modes; ++k)
      {
        to[k] = static_cast<float>(coefficients[k] * reciprocal);
      }
      to += modes;
      coefficients += modes;
    }
  }

private:
  static double Largest(const double* coefficients, int modes)
  {
    Lanes lanes = Splat(0.0);
    int k = 0;
    for (; k + LaneCount() <= modes; k += LaneCount())
    {
      lanes = Max(lanes, Abs(NumberTraits<Lanes>::Load(coefficients + k)));
    }
    double largest = Most(lanes);
    for (; k < modes; ++k)
    {
      largest = std::max(largest, std::fabs(coefficients[k]));
    }
    return largest;
  }
};

/// Evaluates a pack of points in doubles.
template <template <class, class, bool> class Modes>
HWY_NOINLINE TwoLanes InDoubles(
  const Space& space, const double* coefficients, const Point<TwoLanes>& xi)
{
  TwoLanes value = Modes<TwoLanes, AnyOrder, false>(space, xi).Value(coefficients);
  if (!All(IsFinite(value)))
  {
    RescueValue<Modes>(space, coefficients, xi, value);
  }
  return value;
}

/// Loads two packs of points from `at` on. Loads the first pack twice where the second would lie
/// beyond the padding.
HWY_INLINE TwoLanes LoadTwo(const double* from, int at, int count)
{
  const int second = at + LaneCount() < PaddedCount(count) ? at + LaneCount() : at;
  return { NumberTraits<Lanes>::Load(from + at), NumberTraits<Lanes>::Load(from + second) };
}

/// Loads the same points as floats.
HWY_INLINE void LoadFloats(const double* from, int at, int count, FloatLanes& to)
{
  const TwoLanes x = LoadTwo(from, at, count);
  to = ToFloat(x.low, x.high);
}
HWY_INLINE void LoadFloats(const double* from, int at, int count, TwoFloats& to)
{
  LoadFloats(from, at, count, to.low);
  LoadFloats(from, at + kPacksOfFloats * LaneCount(), count, to.high);
}

/// The data of a component, for sums that are recomputed in doubles.
struct FloatTask
{
  const Space& space;
  const double* coefficients;
  double scale;
  const LanePoints& xi;
  double* out;
};

template <template <class, class, bool> class Modes>
HWY_INLINE void StoreFloats(const FloatTask& task, int at, FloatLanes value)
{
  TwoLanes exact = ToDouble(value) * NumberTraits<TwoLanes>::Splat(task.scale);
  if (HWY_UNLIKELY(!All(IsFinite(exact))))
  {
    Point<TwoLanes> xi;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED { xi.x[d] = LoadTwo(task.xi.x[d], at, task.xi.count); });
    exact = Select(IsFinite(exact), exact, InDoubles<Modes>(task.space, task.coefficients, xi));
  }
  Store(exact.low, task.out + at);
  if (kPacksOfFloats > 1 && at + LaneCount() < PaddedCount(task.xi.count))
  {
    Store(exact.high, task.out + at + LaneCount());
  }
}
template <template <class, class, bool> class Modes>
HWY_INLINE void StoreFloats(const FloatTask& task, int at, TwoFloats value)
{
  StoreFloats<Modes>(task, at, value.low);
  StoreFloats<Modes>(task, at + kPacksOfFloats * LaneCount(), value.high);
}

template <template <class, class, bool> class Modes, class Order>
void FloatKernel(const Space& space, const double* coefficients, int components,
  const LanePoints& xi, double* const* out)
{
  thread_local FloatCoefficients floats;
  const int modeCount = space.Modes();
  floats.Round(coefficients, modeCount, components);
  const auto run = [&](auto pack, int i) PIXELEXACT_INLINED
  {
    using T = decltype(pack);
    Point<T> at;
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { LoadFloats(xi.x[d], i, xi.count, at.x[d]); });
    const Modes<T, Order, false> modes(space, at);
    for (int c = 0; c < components; ++c)
    {
      const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(c) * modeCount;
      StoreFloats<Modes>(
        { space, coefficients + first, floats.scales[static_cast<std::size_t>(c)], xi, out[c] }, i,
        modes.Value(floats.values.data() + first));
    }
  };
  const int step = kPacksOfFloats * LaneCount();
  int i = 0;
  // The first points of both packs of a pair must exist.
  for (; i + step < xi.count; i += 2 * step)
  {
    run(TwoFloats(), i);
  }
  if (i < xi.count)
  {
    run(FloatLanes(), i);
  }
}

/// The kernels of SelectKernelSet and those in single precision; the first order, too small to gain
/// from floats, is not compiled in for these.
template <template <class, class, bool> class Modes, int kFirst, int... kOrders>
KernelSet SelectKernels(const Space& space)
{
  KernelSet set = SelectKernelSet<Modes, kFirst, kOrders...>(space);
  set.valueInFloats = &FloatKernel<Modes, AnyOrder>;
  ForFixedOrder<kOrders...>(space,
    [&]<int P>(Const<P> /*order*/) { set.valueInFloats = &FloatKernel<Modes, FixedOrder<P>>; });
  return set;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
