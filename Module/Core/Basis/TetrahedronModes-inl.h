// SPDX-License-Identifier: BSD-3-Clause
// The modal sum of a tetrahedron (Modes-inl.h).
#if defined(PIXELEXACT_TETRAHEDRON_MODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_TETRAHEDRON_MODES_INL_H
#undef PIXELEXACT_TETRAHEDRON_MODES_INL_H
#else
#define PIXELEXACT_TETRAHEDRON_MODES_INL_H
#endif

#include "Core/Basis/Families-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
template <class T, class Order, bool kGradient>
class TetrahedronModes
{
public:
  using Traits = NumberTraits<T>;
  static constexpr Shape kShape = Shape::Tetrahedron;

  HWY_INLINE TetrahedronModes(const Space& space, const Point<T>& xi)
    : order(space)
  {
    using Table = RecurrenceTable<typename Traits::Scalar>;
    const T half = Traits::Splat(0.5);
    const T one = Traits::Splat(1.0);
    const T t1 = Traits::Splat(-0.5) * (xi.x[1] + xi.x[2]);
    const T y1 = one + xi.x[0] - t1;
    FillScaled<kGradient>(Table::Row(0), order.p(), y1, t1, a, a1, a2);
    const T t2 = half * (one - xi.x[2]);
    const T y2 = one + xi.x[1] - t2;
    ForEachUpTo(order.p(),
      [&](auto p) PIXELEXACT_INLINED
      {
        const int row = kGradient ? p : 0;
        FillScaled<kGradient>(Table::Row(2 * p + 1), order.q() - p, y2, t2, b[p], b2[row], b3[row]);
        if constexpr (kGradient)
        {
          // In both families y grows and t falls by a half per unit of the collapsing xi.
          a2[p] = half * (a1[p] - a2[p]);
          ForEachUpTo(order.q() - p,
            [&](auto q) PIXELEXACT_INLINED { b3[p][q] = half * (b2[p][q] - b3[p][q]); });
        }
      });
    ForEachUpTo(order.q(),
      [&](auto n) PIXELEXACT_INLINED
      {
        FillPolynomials<kGradient>(
          Table::Row(2 * n + 2), order.r() - n, xi.x[2], c[n], dc[kGradient ? n : 0]);
      });
  }

  HWY_INLINE T Mode(int p, int q, int r) const { return a[p] * b[p][q] * c[p + q][r]; }

  template <class Coefficient>
  HWY_INLINE T Value(const Coefficient* coefficient) const
  {
    T total = Traits::Splat(0.0);
    ForEachUpTo(order.p(),
      [&](auto p) PIXELEXACT_INLINED
      {
        T sumQ = Traits::Splat(0.0);
        ForEachUpTo(order.q() - p,
          [&](auto q) PIXELEXACT_INLINED
          {
            T sumR = Traits::Splat(0.0);
            ForEachUpTo(order.r() - p - q,
              [&](auto r) PIXELEXACT_INLINED
              { AddTerm(r, Traits::Splat(*coefficient++), c[p + q], sumR); });
            AddTerm(q, sumR, b[p], sumQ);
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
        ForEachUpTo(order.q() - p,
          [&](auto q) PIXELEXACT_INLINED
          {
            T sumR = zero;
            T sumR3 = zero;
            ForEachUpTo(order.r() - p - q,
              [&](auto r) PIXELEXACT_INLINED
              {
                const T u = Traits::Splat(*coefficient++);
                AddTerm(r, u, c[p + q], sumR);
                AddSlope(r, u, dc[p + q], sumR3);
              });
            AddTerm(q, sumR, b[p], sumQ);
            AddSlope(q, sumR, b2[p], sumQ2);
            sumQ3 = MulAdd(sumR, b3[p][q], MulAdd(sumR3, b[p][q], sumQ3));
          });
        const T slope = sumQ * a2[p];
        AddTerm(p, sumQ, a, out.value);
        AddSlope(p, sumQ, a1, out.gradient[0]);
        out.gradient[1] = MulAdd(sumQ2, a[p], out.gradient[1] + slope);
        out.gradient[2] = MulAdd(sumQ3, a[p], out.gradient[2] + slope);
      });
    return out;
  }

private:
  static constexpr int kSize = Order::kCapacity;
  static constexpr int kDerivatives = kGradient ? kSize : 1;
  Order order;
  T a[kSize];
  T a1[kDerivatives];
  T a2[kDerivatives];
  T b[kSize][kSize];
  T b2[kDerivatives][kDerivatives];
  T b3[kDerivatives][kDerivatives];
  T c[kSize][kSize];
  T dc[kDerivatives][kDerivatives];
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
