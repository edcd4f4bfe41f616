// SPDX-License-Identifier: BSD-3-Clause
// Value and gradient of a modal sum by sum factorisation (paper, equation 10), for any number type:
// Lanes in the kernels, FloatLanes where less precision is asked for, long double in the changes of
// basis.
//
// The collapsed families are evaluated as homogeneous polynomials in xi: with y = eta t,
// t^n P_n(y / t) obeys Legendre's recurrence with t^2 in front of its last term. So nothing is
// divided by a vanishing t, and value and gradient are exact up to rounding at collapsed edges and
// vertices too. Only the pyramid's functions, rational in xi, divide by t.
#if defined(PIXELEXACT_MODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_MODES_INL_H
#undef PIXELEXACT_MODES_INL_H
#else
#define PIXELEXACT_MODES_INL_H
#endif

#include "Core/Basis/OrderLoops-inl.h"
#include "Core/Basis/Recurrence.h"
#include "Core/Math/Lanes-inl.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// P_0 .. P_last at z, and on request their derivatives.
template <bool kGradient, class T, class Last>
HWY_INLINE void FillPolynomials(const RecurrenceStep<typename NumberTraits<T>::Scalar>* step,
  Last last, T z, T* value, T* derivative)
{
  using Traits = NumberTraits<T>;
  value[0] = Traits::Splat(1.0);
  if constexpr (kGradient)
  {
    derivative[0] = Traits::Splat(0.0);
  }
  if (last < 1)
  {
    return;
  }
  value[1] = MulAdd(Traits::SplatScalar(step[0].a), z, Traits::SplatScalar(step[0].b));
  if constexpr (kGradient)
  {
    derivative[1] = Traits::SplatScalar(step[0].a);
  }
  ForEachUpTo(last - Const<2>(),
    [&](auto k) PIXELEXACT_INLINED
    {
      const auto n = k + Const<1>();
      const T a = Traits::SplatScalar(step[n].a);
      const T c = Traits::SplatScalar(step[n].c);
      const T slope = MulAdd(a, z, Traits::SplatScalar(step[n].b));
      value[n + 1] = NegMulAdd(c, value[n - 1], slope * value[n]);
      if constexpr (kGradient)
      {
        derivative[n + 1] =
          NegMulAdd(c, derivative[n - 1], MulAdd(slope, derivative[n], a * value[n]));
      }
    });
}

/// t^n P_n(y / t) for n = 0 .. last, and on request the derivatives by y and by t.
template <bool kGradient, class T, class Last>
HWY_INLINE void FillScaled(const RecurrenceStep<typename NumberTraits<T>::Scalar>* step, Last last,
  T y, T t, T* value, T* byY, T* byT)
{
  using Traits = NumberTraits<T>;
  value[0] = Traits::Splat(1.0);
  if constexpr (kGradient)
  {
    byY[0] = Traits::Splat(0.0);
    byT[0] = Traits::Splat(0.0);
  }
  if (last < 1)
  {
    return;
  }
  const T a0 = Traits::SplatScalar(step[0].a);
  const T b0 = Traits::SplatScalar(step[0].b);
  value[1] = MulAdd(a0, y, b0 * t);
  if constexpr (kGradient)
  {
    byY[1] = a0;
    byT[1] = b0;
  }
  const T square = t * t;
  ForEachUpTo(last - Const<2>(),
    [&](auto k) PIXELEXACT_INLINED
    {
      const auto n = k + Const<1>();
      const T a = Traits::SplatScalar(step[n].a);
      const T b = Traits::SplatScalar(step[n].b);
      const T c = Traits::SplatScalar(step[n].c);
      const T slope = MulAdd(a, y, b * t);
      const T cSquare = c * square;
      value[n + 1] = NegMulAdd(cSquare, value[n - 1], slope * value[n]);
      if constexpr (kGradient)
      {
        byY[n + 1] = NegMulAdd(cSquare, byY[n - 1], MulAdd(slope, byY[n], a * value[n]));
        const T twice = (c + c) * t;
        byT[n + 1] = NegMulAdd(
          twice, value[n - 1], NegMulAdd(cSquare, byT[n - 1], MulAdd(slope, byT[n], b * value[n])));
      }
    });
}

// Sums over the functions of a family, of which the first is 1 and its derivative 0: where the
// index is known to the compiler, the first term costs nothing.

/// sum + u table[i]; the sum of no terms is 0.
template <class T, class Index>
HWY_INLINE void AddTerm(Index i, const T& u, const T* table, T& sum)
{
  if constexpr (std::is_same_v<Index, Const<0>>)
  {
    sum = u;
  }
  else
  {
    sum = MulAdd(u, table[i], sum);
  }
}

/// The same with a table of derivatives.
template <class T, class Index>
HWY_INLINE void AddSlope(Index i, const T& u, const T* table, T& sum)
{
  if constexpr (std::is_same_v<Index, Const<1>>)
  {
    sum = u * table[i];
  }
  else if constexpr (!std::is_same_v<Index, Const<0>>)
  {
    sum = MulAdd(u, table[i], sum);
  }
}

/// A point in lanes or as a scalar triple.
template <class T>
struct Point
{
  T x[3];
};

template <class T>
struct ValueAndGradient
{
  T value;
  T gradient[3];
};

/// The tables of one point of a hexahedron; Value and Evaluate contract them with coefficients.
/// All Modes classes below have this interface.
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
