// SPDX-License-Identifier: BSD-3-Clause
// Tables of one-dimensional families at a point, and sums over them, for any number type.
//
// The collapsed families are evaluated as homogeneous polynomials in xi: with y = eta t,
// t^n P_n(y / t) obeys Legendre's recurrence with t^2 in front of its last term. So nothing is
// divided by a vanishing t, and value and gradient are exact up to rounding at collapsed edges and
// vertices too. Only the pyramid's functions, rational in xi, divide by t.
#if defined(PIXELEXACT_FAMILIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_FAMILIES_INL_H
#undef PIXELEXACT_FAMILIES_INL_H
#else
#define PIXELEXACT_FAMILIES_INL_H
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

// Sums over the functions of a family. The first function is 1 and its derivative 0, so the first
// term costs nothing where the compiler knows the index.

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
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
