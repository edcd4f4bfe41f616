// SPDX-License-Identifier: BSD-3-Clause
// Norms max w_i |x_i|, for each ray its own.
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

  /// Of a matrix whose entries are not negative.
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

  HWY_INLINE void AtLeast(int axis, Lanes least, Lanes inverseOfLeast)
  {
    w[axis] = Max(w[axis], least);
    inverse[axis] = Min(inverse[axis], inverseOfLeast);
  }
};

/// In which the rows of K have about the same sum; `plain` is K's norm with all factors 1.
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

/// How large K is in the better of two norms.
HWY_INLINE Lanes LeastNorm(const Lanes (&K)[3][3])
{
  Lanes plain;
  const MaximumNorm even = EvenNorm(K, plain);
  return Min(plain, even.Of(K));
}

/// One in which ClampTo brings no two points farther from each other: the ends of collapsed
/// directions move with the xi that they are clamped after. Of two, the one in which K is smaller;
/// returns how large. A NaN in K gives no number, or an infinite one.
HWY_INLINE Lanes ChooseNorm(Shape shape, const Lanes (&K)[3][3], MaximumNorm& norm)
{
  // x = 1.618...: 1/x + 1/x^2 = 1. The ends of a tetrahedron's eta_1 move with both other xi.
  constexpr double kGolden[3] = { 1.0, 1.6180339887498949, 2.6180339887498949 };
  const bool golden = shape == Shape::Tetrahedron;
  ForEachAxis(
    [&](auto r) PIXELEXACT_INLINED
    {
      norm.w[r] = Splat(golden ? kGolden[r] : 1.0);
      norm.inverse[r] = Splat(golden ? 1.0 / kGolden[r] : 1.0);
    });
  Lanes plain;
  MaximumNorm even = EvenNorm(K, plain);
  if (shape == Shape::Prism)
  {
    even.AtLeast(2, even.w[0], even.inverse[0]);
  }
  else if (shape == Shape::Pyramid)
  {
    even.AtLeast(2, even.w[0], even.inverse[0]);
    even.AtLeast(2, even.w[1], even.inverse[1]);
  }
  else if (golden)
  {
    // w_0 (1 / w_1 + 1 / w_2) <= 1, w_1 <= w_2.
    const auto times = [&](int axis, std::size_t g) PIXELEXACT_INLINED {
      even.AtLeast(axis, Splat(kGolden[g]) * even.w[0], Splat(1.0 / kGolden[g]) * even.inverse[0]);
    };
    times(1, 1);
    even.AtLeast(2, even.w[1], even.inverse[1]);
    times(2, 2);
  }
  const Lanes usual = norm.Of(K);
  const Lanes other = even.Of(K);
  const LaneMask better = other < usual;
  ForEachAxis([&](auto r) PIXELEXACT_INLINED { norm.w[r] = Select(better, even.w[r], norm.w[r]); });
  return Select(better, other, usual);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
