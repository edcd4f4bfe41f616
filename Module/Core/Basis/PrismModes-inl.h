// SPDX-License-Identifier: BSD-3-Clause
// The modal sum of a prism (Modes-inl.h).
#if defined(PIXELEXACT_PRISM_MODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PRISM_MODES_INL_H
#undef PIXELEXACT_PRISM_MODES_INL_H
#else
#define PIXELEXACT_PRISM_MODES_INL_H
#endif

#include "Core/Basis/Families-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
template <class T, class Order, bool kGradient>
class PrismModes
{
public:
  using Traits = NumberTraits<T>;
  static constexpr Shape kShape = Shape::Prism;

  HWY_INLINE PrismModes(const Space& space, const Point<T>& xi)
    : order(space)
  {
    using Table = RecurrenceTable<typename Traits::Scalar>;
    const T half = Traits::Splat(0.5);
    const T one = Traits::Splat(1.0);
    const T t = half * (one - xi.x[2]);
    const T y = one + xi.x[0] - t;
    FillScaled<kGradient>(Table::Row(0), order.p(), y, t, a, a1, a3);
    FillPolynomials<kGradient>(Table::Row(0), order.q(), xi.x[1], b, db);
    ForEachUpTo(order.p(),
      [&](auto p) PIXELEXACT_INLINED
      {
        if constexpr (kGradient)
        {
          // y grows, t falls by a half per unit of xi3.
          a3[p] = half * (a1[p] - a3[p]);
        }
        FillPolynomials<kGradient>(
          Table::Row(2 * p + 1), order.r() - p, xi.x[2], c[p], dc[kGradient ? p : 0]);
      });
  }

  HWY_INLINE T Mode(int p, int q, int r) const { return a[p] * b[q] * c[p][r]; }

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
            T sumR = Traits::Splat(0.0);
            ForEachUpTo(order.r() - p,
              [&](auto r) PIXELEXACT_INLINED
              { AddTerm(r, Traits::Splat(*coefficient++), c[p], sumR); });
            AddTerm(q, sumR, b, sumQ);
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
        T sumQ = zero;
        T sumQ2 = zero;
        T sumQ3 = zero;
        ForEachUpTo(order.q(),
          [&](auto q) PIXELEXACT_INLINED
          {
            T sumR = zero;
            T sumR3 = zero;
            ForEachUpTo(order.r() - p,
              [&](auto r) PIXELEXACT_INLINED
              {
                const T u = Traits::Splat(*coefficient++);
                AddTerm(r, u, c[p], sumR);
                AddSlope(r, u, dc[p], sumR3);
              });
            AddTerm(q, sumR, b, sumQ);
            AddSlope(q, sumR, db, sumQ2);
            AddTerm(q, sumR3, b, sumQ3);
          });
        AddTerm(p, sumQ, a, out.value);
        AddSlope(p, sumQ, a1, out.gradient[0]);
        AddTerm(p, sumQ2, a, out.gradient[1]);
        out.gradient[2] = MulAdd(sumQ3, a[p], MulAdd(sumQ, a3[p], out.gradient[2]));
      });
    return out;
  }

private:
  static constexpr int kSize = Order::kCapacity;
  static constexpr int kDerivatives = kGradient ? kSize : 1;
  Order order;
  T a[kSize];
  T a1[kDerivatives];
  T a3[kDerivatives];
  T b[kSize];
  T db[kDerivatives];
  T c[kSize][kSize];
  T dc[kDerivatives][kDerivatives];
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
