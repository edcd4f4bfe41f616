// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/FloatKernels.cxx"
#include <hwy/foreach_target.h>

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
      double largest = 0.0;
      for (int k = 0; k < modes; ++k)
      {
        largest = std::max(largest, std::fabs(coefficients[k]));
      }
      int exponent = 0;
      if (std::isfinite(largest))
      {
        std::frexp(largest, &exponent);
      }
      // Both powers of two are normal numbers.
      exponent = std::clamp(exponent, -1000, 1000);
      scale = std::ldexp(1.0, exponent);
      const double reciprocal = std::ldexp(1.0, -exponent);
      for (int k = 0; k < modes; ++k)
      {
        *to++ = static_cast<float>(*coefficients++ * reciprocal);
      }
    }
  }
};

/// A pack of points in doubles.
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

template <template <class, class, bool> class Modes, class Order>
void FloatKernel(const Space& space, const double* coefficients, int components,
  const LanePoints& xi, double* const* out)
{
  thread_local FloatCoefficients floats;
  const int modeCount = space.Modes();
  floats.Round(coefficients, modeCount, components);
  const int lanes = LaneCount();
  const int step = FloatLaneCount();
  for (int i = 0; i < xi.count; i += step)
  {
    // Of the last pack the upper half may be missing.
    const bool whole = step > lanes && i + lanes < PaddedCount(xi.count);
    const int upper = whole ? i + lanes : i;
    const auto low = LoadPoint<Lanes>(xi, i);
    const auto high = LoadPoint<Lanes>(xi, upper);
    Point<FloatLanes> at;
    Point<TwoLanes> exact;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        at.x[d] = ToFloat(low.x[d], high.x[d]);
        exact.x[d] = { low.x[d], high.x[d] };
      });
    const Modes<FloatLanes, Order, false> modes(space, at);
    for (int c = 0; c < components; ++c)
    {
      const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(c) * modeCount;
      TwoLanes value = ToDouble(modes.Value(floats.values.data() + first)) *
        NumberTraits<TwoLanes>::Splat(floats.scales[static_cast<std::size_t>(c)]);
      if (HWY_UNLIKELY(!All(IsFinite(value))))
      {
        const TwoLanes rescued = InDoubles<Modes>(space, coefficients + first, exact);
        value = Select(IsFinite(value), value, rescued);
      }
      Store(value.low, out[c] + i);
      if (whole)
      {
        Store(value.high, out[c] + upper);
      }
    }
  }
}

template <template <class, class, bool> class Modes, int... kOrders>
decltype(KernelSet::value) SelectFloatKernel(const Space& space)
{
  decltype(KernelSet::value) kernel = &FloatKernel<Modes, AnyOrder>;
  const auto [p, q, r] = space.order;
  if (p == q && q == r)
  {
    const auto set = [&]<int P>(Const<P> /*order*/)
    {
      if constexpr (P <= kMaxFixedOrder)
      {
        kernel = &FloatKernel<Modes, FixedOrder<P>>;
      }
      return true;
    };
    (void)((p == kOrders ? set(Const<kOrders>()) : false) || ...);
  }
  return kernel;
}

decltype(KernelSet::value) SelectFloats(const Space& space)
{
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return SelectFloatKernel<HexahedronModes, 2, 3, 4, 5, 6, 7, 8>(space);
    case Shape::Prism:
      return SelectFloatKernel<PrismModes, 2, 3, 4, 5, 6, 7, 8>(space);
    case Shape::Tetrahedron:
      return SelectFloatKernel<TetrahedronModes, 2, 3, 4, 5, 6, 7, 8>(space);
    default:
      return space.form == Form::Tensor
        ? SelectFloatKernel<TensorPyramidModes, 2>(space)
        : SelectFloatKernel<PyramidModes, 2, 3, 4, 5, 6, 7, 8>(space);
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(SelectFloats);

decltype(KernelSet::value) FloatValueKernel(const Space& space)
{
  return HWY_DYNAMIC_DISPATCH(SelectFloats)(space);
}
} // namespace pixelexact
#endif
