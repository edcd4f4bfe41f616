// SPDX-License-Identifier: BSD-3-Clause
// Norms max w_i |x_i|, one for each ray.
#if defined(PIXELEXACT_PIECE_NORMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PIECE_NORMS_INL_H
#undef PIXELEXACT_PIECE_NORMS_INL_H
#else
#define PIXELEXACT_PIECE_NORMS_INL_H
#endif

#include "Core/Element/Matrix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Factors w of a norm, and 1 / w.
struct MaximumNorm
{
  Lanes w[3];
  Lanes inverse[3];

  /// The norm of a matrix with non-negative entries.
  [[nodiscard]] HWY_INLINE Lanes Of(const Lanes (&K)[3][3]) const
  {
    Lanes largest = Splat(0.0);
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        largest =
          Max(largest, w[r] * (K[r][0] * inverse[0] + K[r][1] * inverse[1] + K[r][2] * inverse[2]));
      });
    return largest;
  }
};

/// A norm in which the rows of K have about the same sum; `plain`: K's norm with all factors 1.
HWY_INLINE MaximumNorm EvenNorm(const Lanes (&K)[3][3], Lanes& plain)
{
  Lanes sum[3];
  plain = Splat(0x1p-500);
  ForEachAxis(
    [&](auto r) PIXELEXACT_INLINED
    {
      sum[r] = K[r][0] + K[r][1] + K[r][2];
      plain = Max(plain, sum[r]);
    });
  const Lanes least = Splat(1e-2) * plain;
  const Lanes scale = Splat(1.0) / plain;
  MaximumNorm norm;
  ForEachAxis(
    [&](auto r) PIXELEXACT_INLINED
    {
      const Lanes kept = Max(sum[r], least);
      norm.w[r] = plain / kept;
      norm.inverse[r] = kept * scale;
    });
  return norm;
}

/// The norm of K in the better of two norms.
HWY_INLINE Lanes LeastNorm(const Lanes (&K)[3][3])
{
  Lanes plain;
  const MaximumNorm even = EvenNorm(K, plain);
  return Min(plain, even.Of(K));
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
