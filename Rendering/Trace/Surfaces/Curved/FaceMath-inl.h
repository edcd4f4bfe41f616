// SPDX-License-Identifier: BSD-3-Clause
// The functions of PieceMath-inl.h and PieceNorms-inl.h for the two unknowns of a face's chart.
#if defined(PIXELEXACT_FACE_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_FACE_MATH_INL_H
#undef PIXELEXACT_FACE_MATH_INL_H
#else
#define PIXELEXACT_FACE_MATH_INL_H
#endif

#include "Core/Element/Matrix-inl.h"
#include "Trace/Surfaces/Curved/FaceChart.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Calls visit(j) for j = 0, 1, unrolled.
template <class Visit>
HWY_INLINE void ForBoth(Visit&& visit)
{
  ForEachUpTo(Const<1>(), visit);
}

/// The inverse; not finite if there is none.
HWY_INLINE void InverseOf(const Lanes (&m)[2][2], Lanes (&inverse)[2][2])
{
  const Lanes scale = Splat(1.0) / (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  inverse[0][0] = m[1][1] * scale;
  inverse[0][1] = (Splat(0.0) - m[0][1]) * scale;
  inverse[1][0] = (Splat(0.0) - m[1][0]) * scale;
  inverse[1][1] = m[0][0] * scale;
}

/// Clamps a point outside a piece to it: first v, then u.
HWY_INLINE void ClampTo(bool collapses, const Lanes (&lower)[2], const Lanes (&upper)[2],
  const Lanes (&at)[2], Lanes (&x)[2])
{
  x[1] = Max(Min(at[1], upper[1]), lower[1]);
  if (!collapses)
  {
    x[0] = Max(Min(at[0], upper[0]), lower[0]);
    return;
  }
  const Lanes one = Splat(1.0);
  const Lanes extent = Splat(0.5) * (one - x[1]);
  x[0] = Max(Min(at[0], (one + upper[0]) * extent - one), (one + lower[0]) * extent - one);
}

/// The third xi.
HWY_INLINE Lanes AcrossAt(const FaceChart& chart, const Lanes (&at)[2])
{
  return Splat(chart.constant) + Splat(chart.along[0]) * at[0] + Splat(chart.along[1]) * at[1];
}

/// Factors w of a norm max w_i |x_i| in which the rows of K, whose entries are not negative, have
/// about the same sum; `plain`: K's norm with all factors 1.
HWY_INLINE void EvenNorm(const Lanes (&K)[2][2], Lanes (&w)[2], Lanes& plain)
{
  const Lanes sum[2] = { K[0][0] + K[0][1], K[1][0] + K[1][1] };
  plain = Max(Splat(0x1p-500), Max(sum[0], sum[1]));
  const Lanes least = Splat(1e-2) * plain;
  ForBoth([&](auto r) PIXELEXACT_INLINED { w[r] = plain / Max(sum[r], least); });
}

HWY_INLINE Lanes NormOf(const Lanes (&K)[2][2], const Lanes (&w)[2])
{
  const Lanes ratio = w[0] / w[1];
  const Lanes first = K[0][0] + K[0][1] * ratio;
  const Lanes second = K[1][0] / ratio + K[1][1];
  return Max(first, second);
}

/// The norm of K in the better of two norms.
HWY_INLINE Lanes LeastNorm(const Lanes (&K)[2][2])
{
  Lanes plain;
  Lanes even[2];
  EvenNorm(K, even, plain);
  return Min(plain, NormOf(K, even));
}

/// Chooses the better of two norms in which ClampTo increases no distance, and returns K's norm. A
/// NaN in K gives NaN or infinity.
HWY_INLINE Lanes ChooseNorm(bool collapses, const Lanes (&K)[2][2], Lanes (&w)[2])
{
  Lanes plain;
  EvenNorm(K, w, plain);
  if (collapses)
  {
    w[1] = Max(w[1], w[0]);
  }
  const Lanes even = NormOf(K, w);
  const LaneMask better = even < plain;
  ForBoth([&](auto r) PIXELEXACT_INLINED { w[r] = Select(better, w[r], Splat(1.0)); });
  return Select(better, even, plain);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
