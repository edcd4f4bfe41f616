// SPDX-License-Identifier: BSD-3-Clause
// Points and 3 x 3 matrices of lanes, for the inverse map.
#if defined(PIXELEXACT_MATRIX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_MATRIX_INL_H
#undef PIXELEXACT_MATRIX_INL_H
#else
#define PIXELEXACT_MATRIX_INL_H
#endif

#include "Core/Basis/Modes-inl.h"
#include "Core/Element/Kernels.h"
#include "Core/Math/Pair-inl.h"
#include "Core/Math/TwoLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
HWY_INLINE Lanes Splat(double value)
{
  return NumberTraits<Lanes>::Splat(value);
}

template <class T>
HWY_INLINE Point<T> LoadPoint(const LanePoints& points, int at)
{
  using Traits = NumberTraits<T>;
  return { { Traits::Load(points.x[0] + at), Traits::Load(points.x[1] + at),
    Traits::Load(points.x[2] + at) } };
}

/// A 3 x 3 matrix, row-major.
template <class T>
struct Matrix
{
  T m[9];
};

template <class T>
HWY_INLINE Point<T> Apply(const Matrix<T>& a, const Point<T>& x)
{
  Point<T> y;
  ForEachAxis(
    [&](auto i) PIXELEXACT_INLINED {
      y.x[i] = MulAdd(a.m[3 * i], x.x[0], MulAdd(a.m[3 * i + 1], x.x[1], a.m[3 * i + 2] * x.x[2]));
    });
  return y;
}

/// a b - c d to two roundings of the result, however much cancels (W. Kahan; C.-P. Jeannerod,
/// N. Louvet, J.-M. Muller, Further analysis of Kahan's algorithm for the accurate computation of
/// 2x2 determinants, Mathematics of Computation 82, 2013).
HWY_INLINE Lanes Minor(Lanes a, Lanes b, Lanes c, Lanes d)
{
  const Pair cd = ExactProduct(c, d);
#if HWY_NATIVE_FMA
  return MulSub(a, b, cd.high) - cd.low;
#else
  const Pair ab = ExactProduct(a, b);
  return (ab.high - cd.high) + (ab.low - cd.low);
#endif
}

/// The inverse by cofactors; infinite or NaN where the matrix is singular. Accurate to the
/// condition number: of an element stretched 1:10^8 plain cofactors would be rounding alone.
template <class T>
HWY_INLINE Matrix<T> Inverse(const Matrix<T>& a)
{
  const auto& m = a.m;
  const T c0 = Minor(m[4], m[8], m[5], m[7]);
  const T c1 = Minor(m[5], m[6], m[3], m[8]);
  const T c2 = Minor(m[3], m[7], m[4], m[6]);
  const T det = MulAdd(m[0], c0, MulAdd(m[1], c1, m[2] * c2));
  const T s = NumberTraits<T>::Splat(1.0) / det;
  return { { c0 * s, Minor(m[2], m[7], m[1], m[8]) * s, Minor(m[1], m[5], m[2], m[4]) * s, c1 * s,
    Minor(m[0], m[8], m[2], m[6]) * s, Minor(m[2], m[3], m[0], m[5]) * s, c2 * s,
    Minor(m[1], m[6], m[0], m[7]) * s, Minor(m[0], m[4], m[1], m[3]) * s } };
}

template <class T>
HWY_INLINE T MaxAbs(const Point<T>& x)
{
  return Max(Max(Abs(x.x[0]), Abs(x.x[1])), Abs(x.x[2]));
}

/// sum over k of |M_dk| u_k: how far the uncertainty of Phi and y takes xi.
template <class T>
HWY_INLINE Point<T> ToleranceOf(const Matrix<T>& inverse, const double* uncertainty)
{
  using Traits = NumberTraits<T>;
  Point<T> tolerance;
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      tolerance.x[d] = Traits::Splat(0.0);
      ForEachAxis(
        [&](auto k) PIXELEXACT_INLINED
        {
          tolerance.x[d] =
            MulAdd(Abs(inverse.m[3 * d + k]), Traits::Splat(uncertainty[k]), tolerance.x[d]);
        });
    });
  return tolerance;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
