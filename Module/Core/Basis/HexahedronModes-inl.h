// SPDX-License-Identifier: BSD-3-Clause
// The modal sum of a hexahedron (Modes-inl.h).
#if defined(PIXELEXACT_HEXAHEDRON_MODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_HEXAHEDRON_MODES_INL_H
#undef PIXELEXACT_HEXAHEDRON_MODES_INL_H
#else
#define PIXELEXACT_HEXAHEDRON_MODES_INL_H
#endif

#include "Core/Basis/Families-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The tables of one point of a hexahedron; Value and Evaluate contract them with coefficients.
/// The other shapes' classes have this interface.
template <class T, class Order, bool kGradient>
class HexahedronModes
{
public:
  using Traits = NumberTraits<T>;
  static constexpr Shape kShape = Shape::Hexahedron;

  HWY_INLINE HexahedronModes(const Space& space, const Point<T>& xi)
    : order(space)
  {
    const auto* legendre = RecurrenceTable<typename Traits::Scalar>::Row(0);
    FillPolynomials<kGradient>(legendre, order.p(), xi.x[0], a, da);
    FillPolynomials<kGradient>(legendre, order.q(), xi.x[1], b, db);
    FillPolynomials<kGradient>(legendre, order.r(), xi.x[2], c, dc);
  }

  HWY_INLINE T Mode(int p, int q, int r) const { return a[p] * b[q] * c[r]; }

  template <class Coefficient>
  HWY_INLINE T Value(const Coefficient* coefficient) const
  {
    T total = Traits::Splat(0.0);
    ForEachOuterUpTo(order.p(),
      [&](auto p) PIXELEXACT_INLINED
      {
        T sumQ = Traits::Splat(0.0);
        ForEachUpTo(order.q(),
          [&](auto q) PIXELEXACT_INLINED
          {
            T sumR = Traits::Splat(0.0);
            ForEachUpTo(order.r(),
              [&](auto r) PIXELEXACT_INLINED
              { AddTerm(r, Traits::Splat(*coefficient++), c, sumR); });
            AddTerm(q, sumR, b, sumQ);
          });
        AddTerm(p, sumQ, a, total);
      });
    return total;
  }

  /// Gradient with respect to xi.
  HWY_INLINE ValueAndGradient<T> Evaluate(const double* coefficient) const
  {
    const T zero = Traits::Splat(0.0);
    ValueAndGradient<T> out{ zero, { zero, zero, zero } };
    ForEachOuterUpTo(order.p(),
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
            ForEachUpTo(order.r(),
              [&](auto r) PIXELEXACT_INLINED
              {
                const T u = Traits::Splat(*coefficient++);
                AddTerm(r, u, c, sumR);
                AddSlope(r, u, dc, sumR3);
              });
            AddTerm(q, sumR, b, sumQ);
            AddSlope(q, sumR, db, sumQ2);
            AddTerm(q, sumR3, b, sumQ3);
          });
        AddTerm(p, sumQ, a, out.value);
        AddSlope(p, sumQ, da, out.gradient[0]);
        AddTerm(p, sumQ2, a, out.gradient[1]);
        AddTerm(p, sumQ3, a, out.gradient[2]);
      });
    return out;
  }

private:
  static constexpr int kSize = Order::kCapacity;
  static constexpr int kDerivatives = kGradient ? kSize : 1;
  Order order;
  T a[kSize];
  T b[kSize];
  T c[kSize];
  T da[kDerivatives];
  T db[kDerivatives];
  T dc[kDerivatives];
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
