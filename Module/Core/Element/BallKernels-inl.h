// SPDX-License-Identifier: BSD-3-Clause
// Functions and their gradients over boxes, in balls, for every shape at run time. Included once
// per instruction set.
#if defined(PIXELEXACT_BALL_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_BALL_KERNELS_INL_H
#undef PIXELEXACT_BALL_KERNELS_INL_H
#else
#define PIXELEXACT_BALL_KERNELS_INL_H
#endif

#include "Core/Basis/BallModes-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Values over a box, per component.
using BallValues = void (*)(
  const Space&, const double* coefficients, int components, const Point<Ball>& xi, Ball* value);
/// Evaluates values, and gradients by xi, three per component.
using BallGradients = void (*)(const Space&, const double* coefficients, int components,
  const Point<Ball>& xi, Ball* value, Ball* gradient);

struct BallKernels
{
  BallValues values;
  BallGradients gradients;
  /// The values by ball arithmetic alone, step by step: no derivative narrows them.
  BallValues plainValues;
};

/// `kPlain`: the tables of functions are those of the gradients (BallModes-inl.h).
template <template <class, class, bool> class Modes, bool kPlain>
void ValuesOf(const Space& space, const double* coefficients, int components, const Point<Ball>& xi,
  Ball* value)
{
  const Modes<Ball, AnyOrder, kPlain> modes(space, xi);
  const int modeCount = space.Modes();
  for (int c = 0; c < components; ++c)
  {
    value[c] = modes.Value(coefficients + static_cast<std::ptrdiff_t>(c) * modeCount);
  }
}

template <template <class, class, bool> class Modes>
void GradientsOf(const Space& space, const double* coefficients, int components,
  const Point<Ball>& xi, Ball* value, Ball* gradient)
{
  const Modes<Ball, AnyOrder, true> modes(space, xi);
  const int modeCount = space.Modes();
  for (int c = 0; c < components; ++c)
  {
    const auto e = modes.Evaluate(coefficients + static_cast<std::ptrdiff_t>(c) * modeCount);
    value[c] = e.value;
    std::copy_n(e.gradient, 3, gradient + static_cast<std::ptrdiff_t>(3) * c);
  }
}

template <template <class, class, bool> class Modes>
BallKernels BallKernelsOf()
{
  return { &ValuesOf<Modes, false>, &GradientsOf<Modes>, &ValuesOf<Modes, true> };
}

inline BallKernels BallKernelsFor(const Space& space)
{
  switch (space.shape)
  {
    case Shape::Hexahedron:
      return BallKernelsOf<HexahedronModes>();
    case Shape::Prism:
      return BallKernelsOf<PrismModes>();
    case Shape::Tetrahedron:
      return BallKernelsOf<TetrahedronModes>();
    default:
      return space.form == Form::Tensor ? BallKernelsOf<TensorPyramidModes>()
                                        : BallKernelsOf<PyramidModes>();
  }
}

HWY_INLINE Point<Ball> BoxAround(const Point<Lanes>& middle, const Point<Lanes>& radius)
{
  return { { { middle.x[0], radius.x[0] }, { middle.x[1], radius.x[1] },
    { middle.x[2], radius.x[2] } } };
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
