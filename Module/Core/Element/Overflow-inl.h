// SPDX-License-Identifier: BSD-3-Clause
// Recomputes values and gradients that are finite, but whose sums overflow at intermediate terms.
//
// Modes of high orders on collapsed shapes are products of large and small factors, so that sums of
// coefficients near 1e300 overflow at intermediate terms. Coefficients scaled by a power of two
// give the same sums up to that scale, so the sums are recomputed with smaller coefficients.
#if defined(PIXELEXACT_OVERFLOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_OVERFLOW_INL_H
#undef PIXELEXACT_OVERFLOW_INL_H
#else
#define PIXELEXACT_OVERFLOW_INL_H
#endif

#include "Core/Basis/Modes-inl.h"
#include "Core/Element/Matrix-inl.h"

#include <vector>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Exact, and enough for any number of modes.
inline constexpr double kOverflowScale = 0x1p-256;

inline std::vector<double> ScaledDown(const double* coefficients, int count)
{
  std::vector<double> scaled(coefficients, coefficients + count);
  for (double& c : scaled)
  {
    c *= kOverflowScale;
  }
  return scaled;
}

/// Puts the value where it is not finite. Lanes that are keep what they have: a point's result does
/// not depend on its neighbours.
template <template <class, class, bool> class Modes, class T>
HWY_NOINLINE void RescueValue(
  const Space& space, const double* coefficients, const Point<T>& xi, T& value)
{
  const auto scaled = ScaledDown(coefficients, space.Modes());
  const T rescued = Modes<T, AnyOrder, false>(space, xi).Value(scaled.data()) *
    NumberTraits<T>::Splat(1.0 / kOverflowScale);
  value = Select(IsFinite(value), value, rescued);
}

/// The same for value and gradient, in lanes where one of them or their sum is not finite.
template <template <class, class, bool> class Modes, class T, class Mask>
HWY_NOINLINE void RescueGradient(const Space& space, const double* coefficients, const Point<T>& xi,
  Mask finite, ValueAndGradient<T>& e)
{
  const auto scaled = ScaledDown(coefficients, space.Modes());
  const T back = NumberTraits<T>::Splat(1.0 / kOverflowScale);
  const auto rescued = Modes<T, AnyOrder, true>(space, xi).Evaluate(scaled.data());
  e.value = Select(finite, e.value, rescued.value * back);
  for (int d = 0; d < 3; ++d)
  {
    e.gradient[d] = Select(finite, e.gradient[d], rescued.gradient[d] * back);
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
