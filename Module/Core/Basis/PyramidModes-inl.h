// SPDX-License-Identifier: BSD-3-Clause
// The modal sums of a pyramid (Modes-inl.h): its Collapsed and its Tensor form.
#if defined(PIXELEXACT_PYRAMID_MODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PYRAMID_MODES_INL_H
#undef PIXELEXACT_PYRAMID_MODES_INL_H
#else
#define PIXELEXACT_PYRAMID_MODES_INL_H
#endif

#include "Core/Basis/HexahedronModes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The pyramid's Collapsed form. The powers of t = (1 - xi3) / 2 that stand in each mode take up
/// the division by t in its derivatives.
template <class T, class Order, bool kGradient>
class PyramidModes
{
public:
  using Traits = NumberTraits<T>;
  static constexpr Shape kShape = Shape::Pyramid;

  HWY_INLINE PyramidModes(const Space& space, const Point<T>& xi)
    : order(space)
  {
    using Table = RecurrenceTable<typename Traits::Scalar>;
    const T half = Traits::Splat(0.5);
    const T one = Traits::Splat(1.0);
    const T t = half * (one - xi.x[2]);
    const T eta1 = CollapsedQuotient(one + xi.x[0] - t, t);
    const T eta2 = CollapsedQuotient(one + xi.x[1] - t, t);
    slope1 = half * (one + eta1);
    slope2 = half * (one + eta2);
    FillPolynomials<kGradient>(Table::Row(0), order.p(), eta1, a, da);
    FillPolynomials<kGradient>(Table::Row(0), order.q(), eta2, b, db);
    power[0] = one;
    ForEachUpTo(Larger(order.p(), order.q()),
      [&](auto m) PIXELEXACT_INLINED
      {
        power[m + 1] = power[m] * t;
        FillPolynomials<kGradient>(
          Table::Row(2 * m + 2), order.r() - m, xi.x[2], c[m], dc[kGradient ? m : 0]);
      });
  }

  HWY_INLINE T Mode(int p, int q, int r) const
  {
    const auto m = Larger(p, q);
    return a[p] * b[q] * power[m] * c[m][r];
  }

  template <class Coefficient>
  HWY_INLINE T Value(const Coefficient* coefficient) const
  {
    T total = Traits::Splat(0.0);
    ForEachUpTo(order.p(),
      [&](auto p) PIXELEXACT_INLINED
      {
        T sumQ = Traits::Splat(0.0);
        ForEachUpTo(order.q(),
          [&](auto q) PIXELEXACT_INLINED
          {
            const auto m = Larger(p, q);
            T sumR = Traits::Splat(0.0);
            ForEachUpTo(order.r() - m,
              [&](auto r) PIXELEXACT_INLINED
              { AddTerm(r, Traits::Splat(*coefficient++), c[m], sumR); });
            sumQ = MulAdd(sumR * power[m], b[q], sumQ);
          });
        AddTerm(p, sumQ, a, total);
      });
    return total;
  }

  HWY_INLINE ValueAndGradient<T> Evaluate(const double* coefficient) const
  {
    const T zero = Traits::Splat(0.0);
    ValueAndGradient<T> out{ zero, { zero, zero, zero } };
    ForEachUpTo(order.p(),
      [&](auto p) PIXELEXACT_INLINED
      {
        T sumQ = zero;     // value
        T sumQ3 = zero;    // derivative by xi3 at fixed eta1, eta2
        T reduced = zero;  // value / t
        T reduced2 = zero; // derivative by eta2, / t
        ForEachUpTo(order.q(),
          [&](auto q) PIXELEXACT_INLINED
          {
            const auto m = Larger(p, q);
            T sumR = zero;
            T sumR3 = zero;
            ForEachUpTo(order.r() - m,
              [&](auto r) PIXELEXACT_INLINED
              {
                const T u = Traits::Splat(*coefficient++);
                AddTerm(r, u, c[m], sumR);
                AddSlope(r, u, dc[m], sumR3);
              });
            const T scaled = sumR * power[m];
            T scaled3 = sumR3 * power[m];
            if (m > 0)
            {
              const T lower = sumR * power[m - 1];
              scaled3 = MulAdd(Traits::Splat(-0.5 * m), lower, scaled3);
              AddTerm(q, lower, b, reduced);
              AddSlope(q, lower, db, reduced2);
            }
            AddTerm(q, scaled, b, sumQ);
            AddTerm(q, scaled3, b, sumQ3);
          });
        const T by1 = reduced * da[p];
        const T by2 = reduced2 * a[p];
        AddTerm(p, sumQ, a, out.value);
        out.gradient[0] = out.gradient[0] + by1;
        out.gradient[1] = out.gradient[1] + by2;
        out.gradient[2] =
          MulAdd(sumQ3, a[p], MulAdd(by1, slope1, MulAdd(by2, slope2, out.gradient[2])));
      });
    return out;
  }

private:
  static constexpr int kSize = Order::kCapacity;
  static constexpr int kDerivatives = kGradient ? kSize : 1;
  Order order;
  T slope1;
  T slope2;
  T a[kSize];
  T da[kDerivatives];
  T b[kSize];
  T db[kDerivatives];
  T c[kSize][kSize];
  T dc[kDerivatives][kDerivatives];
  T power[kSize + 1];
};

/// The pyramid's Tensor form: a hexahedron's sum in eta.
template <class T, class Order, bool kGradient>
class TensorPyramidModes
{
public:
  using Traits = NumberTraits<T>;
  static constexpr Shape kShape = Shape::Pyramid;

  HWY_INLINE TensorPyramidModes(const Space& space, const Point<T>& xi)
    : eta(Eta(xi))
    , reciprocal(SafeReciprocal(Traits::Splat(0.5) * (Traits::Splat(1.0) - xi.x[2])))
    , modes(space, eta)
  {
  }

  HWY_INLINE T Mode(int p, int q, int r) const { return modes.Mode(p, q, r); }
  template <class Coefficient>
  HWY_INLINE T Value(const Coefficient* coefficient) const
  {
    return modes.Value(coefficient);
  }

  HWY_INLINE ValueAndGradient<T> Evaluate(const double* coefficient) const
  {
    const T half = Traits::Splat(0.5);
    const T one = Traits::Splat(1.0);
    ValueAndGradient<T> out = modes.Evaluate(coefficient);
    out.gradient[0] = out.gradient[0] * reciprocal;
    out.gradient[1] = out.gradient[1] * reciprocal;
    out.gradient[2] = MulAdd(out.gradient[0], half * (one + eta.x[0]),
      MulAdd(out.gradient[1], half * (one + eta.x[1]), out.gradient[2]));
    return out;
  }

private:
  static HWY_INLINE Point<T> Eta(const Point<T>& xi)
  {
    const T one = Traits::Splat(1.0);
    const T t = Traits::Splat(0.5) * (one - xi.x[2]);
    return { { CollapsedQuotient(one + xi.x[0] - t, t), CollapsedQuotient(one + xi.x[1] - t, t),
      xi.x[2] } };
  }
  Point<T> eta;
  T reciprocal;
  HexahedronModes<T, Order, kGradient> modes;
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
