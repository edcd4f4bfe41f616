// SPDX-License-Identifier: BSD-3-Clause
// The start of the inverse map, in lanes: a first guess of xi, and the side of the faces on which a
// xi lies.
#if defined(PIXELEXACT_GUESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_GUESS_INL_H
#undef PIXELEXACT_GUESS_INL_H
#else
#define PIXELEXACT_GUESS_INL_H
#endif

#include "Core/Element/Kernels.h"
#include "Core/Element/Matrix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Signed distances to the faces, each widened by the tolerance t of the coordinates that it
/// depends on.
template <class T>
HWY_INLINE T WidenedMargin(Shape shape, const Point<T>& xi, const Point<T>& t)
{
  const T one = NumberTraits<T>::Splat(1.0);
  const T zero = NumberTraits<T>::Splat(0.0);
  const T low = Min(Min(one + xi.x[0] + t.x[0], one + xi.x[1] + t.x[1]), one + xi.x[2] + t.x[2]);
  switch (shape)
  {
    case Shape::Hexahedron:
      return Min(
        low, Min(Min(one - xi.x[0] + t.x[0], one - xi.x[1] + t.x[1]), one - xi.x[2] + t.x[2]));
    case Shape::Prism:
      return Min(low, Min(one - xi.x[1] + t.x[1], zero - (xi.x[0] + xi.x[2]) + (t.x[0] + t.x[2])));
    case Shape::Tetrahedron:
      return Min(low, zero - (one + xi.x[0] + xi.x[1] + xi.x[2]) + (t.x[0] + t.x[1] + t.x[2]));
    default:
      return Min(low,
        Min(zero - (xi.x[0] + xi.x[2]) + (t.x[0] + t.x[2]),
          zero - (xi.x[1] + xi.x[2]) + (t.x[1] + t.x[2])));
  }
}

/// The inverse map's first guess from the frame's.
template <class T>
HWY_INLINE Point<T> Guess(const InverseProblem& problem, const Point<T>& start)
{
  using Traits = NumberTraits<T>;
  using Degree = Const<kGuessDegree>;
  Point<T> s;
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      s.x[d] =
        (start.x[d] - Traits::Splat(problem.guessCentre[d])) * Traits::Splat(problem.guessScale[d]);
      // Beyond the shape's image the polynomial may be anything.
      s.x[d] = Max(Min(s.x[d], Traits::Splat(1.0)), Traits::Splat(-1.0));
    });
  Point<T> xi;
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      const double* term = problem.guess + static_cast<std::ptrdiff_t>(d) * kGuessTerms;
      // Horner's rule in each variable: the powers fall.
      T sum = Traits::Splat(0.0);
      ForEachUpTo(Degree(),
        [&](auto i) PIXELEXACT_INLINED
        {
          T sumJ = Traits::Splat(0.0);
          ForEachUpTo(i,
            [&](auto j) PIXELEXACT_INLINED
            {
              T sumK = Traits::Splat(*term++);
              ForEachUpTo(j - Const<1>(),
                [&](auto /*k*/) PIXELEXACT_INLINED
                { sumK = MulAdd(sumK, s.x[2], Traits::Splat(*term++)); });
              sumJ = MulAdd(sumJ, s.x[1], sumK);
            });
          sum = MulAdd(sum, s.x[0], sumJ);
        });
      xi.x[d] = sum;
    });
  return xi;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
