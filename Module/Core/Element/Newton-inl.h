// SPDX-License-Identifier: BSD-3-Clause
// Newton's iteration for Phi(xi) = y, many points of one element at a time. T is Lanes.
#if defined(PIXELEXACT_NEWTON_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_NEWTON_INL_H
#undef PIXELEXACT_NEWTON_INL_H
#else
#define PIXELEXACT_NEWTON_INL_H
#endif

#include "Core/Element/Kernels.h"
#include "Core/Element/Matrix-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A lane is done when its next error is expected to be below the first, which the polishing step
/// measures and takes away, and what polishing leaves below the second.
inline constexpr double kSmallError = 2e-11;
/// Both are overestimates: what is left is mostly rounding.
inline constexpr double kNoError = 1e-15;
/// A kept Jacobian is made anew when a step is not this much smaller than the one before: a new one
/// costs as much as two steps with the old one.
inline constexpr double kContraction = 0.02;
inline constexpr int kMaxNewtonSteps = 24;
/// A root farther out than this cannot be the element's; the careful path decides.
inline constexpr double kFarOut = 8.0;

/// What a step's length is measured by. A pyramid's map bends on the scale of the distance to its
/// apex, all others on that of the shape.
template <class T>
HWY_INLINE T StepScale(Shape shape, const Point<T>& xi)
{
  const T one = NumberTraits<T>::Splat(1.0);
  return shape == Shape::Pyramid ? Min(one, NumberTraits<T>::Splat(0.5) * Abs(one - xi.x[2])) : one;
}

/// Next to its apex a pyramid's functions are constant past the faces (CollapsedQuotient), and an
/// iteration that gets there does not come back. It goes on from the point that has the value.
template <class T>
HWY_INLINE void BackOntoCone(Point<T>& xi)
{
  const T zero = NumberTraits<T>::Splat(0.0);
  const T one = NumberTraits<T>::Splat(1.0);
  const T width = one - xi.x[2];
  const auto close = Abs(width) < NumberTraits<T>::Splat(2e-8);
  for (int d = 0; d < 2; ++d)
  {
    const T at = Max(Min(one + xi.x[d], Max(width, zero)), Min(width, zero));
    xi.x[d] = Select(close, at - one, xi.x[d]);
  }
}

template <class T>
struct NewtonState
{
  Point<T> xi;
  Matrix<T> inverse; ///< of the last Jacobian
  T failed;          ///< 1 where the iteration gave up, else 0
  T steps;
  T unsettled; ///< the last step, where steps do not get smaller, else 0
  T madeFor;   ///< the step from where the last Jacobian was made
};

/// Phi(xi) - y.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_INLINE Point<T> Residual(
  const InverseProblem& problem, int modeCount, const Point<T>& y, const Point<T>& xi)
{
  const Modes<T, Order, false> modes(problem.space, xi);
  Point<T> residual;
  ForEachAxis(
    [&](auto c) PIXELEXACT_INLINED
    {
      residual.x[c] =
        modes.Value(problem.coefficients + static_cast<std::ptrdiff_t>(c) * modeCount) - y.x[c];
    });
  return residual;
}

/// The same, and the Jacobian. The residual's bits are those of Residual.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_INLINE Point<T> ResidualAndJacobian(const InverseProblem& problem, int modeCount,
  const Point<T>& y, const Point<T>& xi, Matrix<T>& jacobian)
{
  const Modes<T, Order, true> modes(problem.space, xi);
  Point<T> residual;
  ForEachAxis(
    [&](auto c) PIXELEXACT_INLINED
    {
      const auto e =
        modes.Evaluate(problem.coefficients + static_cast<std::ptrdiff_t>(c) * modeCount);
      residual.x[c] = e.value - y.x[c];
      ForEachAxis([&](auto d) PIXELEXACT_INLINED { jacobian.m[3 * c + d] = e.gradient[d]; });
    });
  return residual;
}

/// The same, and the inverse of the Jacobian.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_INLINE Point<T> ResidualAndInverse(const InverseProblem& problem, int modeCount,
  const Point<T>& y, const Point<T>& xi, Matrix<T>& inverse)
{
  Matrix<T> jacobian;
  const Point<T> residual = ResidualAndJacobian<Modes, Order>(problem, modeCount, y, xi, jacobian);
  inverse = Inverse(jacobian);
  return residual;
}

/// xi - delta. Steps longer than the shape are shortened: far from the root they say no more than a
/// direction. Returns the step's whole length.
template <Shape kShape, class T>
HWY_INLINE T Move(Point<T> delta, Point<T>& xi)
{
  const T one = NumberTraits<T>::Splat(1.0);
  const T length = MaxAbs(delta);
  if (HWY_UNLIKELY(!All(length <= one)))
  {
    const T scale = Select(length <= one, one, one / length);
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { delta.x[d] = delta.x[d] * scale; });
  }
  ForEachAxis([&](auto d) PIXELEXACT_INLINED { xi.x[d] = xi.x[d] - delta.x[d]; });
  if (kShape == Shape::Pyramid)
  {
    BackOntoCone(xi);
  }
  return length;
}

/// One step from xi.
template <Shape kShape, class T>
HWY_INLINE T Step(const Matrix<T>& inverse, const Point<T>& residual, Point<T>& xi)
{
  return Move<kShape>(Apply(inverse, residual), xi);
}

/// A NaN is not, so that it ends as failed.
template <class T>
HWY_INLINE auto IsSound(const T& length, const Point<T>& xi)
{
  return And(length >= NumberTraits<T>::Splat(0.0), MaxAbs(xi) <= NumberTraits<T>::Splat(kFarOut));
}

/// Whether steps that fall to `rated` of `before` with a step of `length` leave nothing more to do
/// than polishing.
template <class T>
HWY_INLINE auto IsDone(const T& length, const T& rated, const T& before, const T& unit)
{
  using Traits = NumberTraits<T>;
  const T next = length * rated;
  return And(next <= Traits::Splat(kSmallError) * unit * before,
    next * rated <= Traits::Splat(kNoError) * unit * before * before);
}

/// Goes on after a first step of length `first`. What a lane does depends on its own steps alone,
/// and when it is done it keeps its state, so that its result does not depend on the others.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_NOINLINE void GoOn(const InverseProblem& problem, int modeCount, const Point<T>& y,
  const T& first, NewtonState<T>& state)
{
  using Traits = NumberTraits<T>;
  constexpr Shape shape = Modes<T, Order, false>::kShape;
  const T zero = Traits::Splat(0.0);
  const T one = Traits::Splat(1.0);
  const T curvature = Traits::Splat(problem.curvature);
  // A Jacobian that gains too little a step is not worth its cheaper steps.
  const T keep = Traits::Splat(std::min(kKeepJacobian, kContraction / problem.curvature));
  const T unit = StepScale(shape, state.xi);
  T last = first;
  T madeFor = first; // the step that the Jacobian was made for
  const auto sound = IsSound(first, state.xi);
  state.failed = Select(sound, zero, one);
  auto active = AndNot(sound, IsDone(first, curvature * first, unit, unit));
  auto renew = AndNot(active, madeFor <= keep * unit); // lanes that need a new Jacobian
  for (int step = 1; step < kMaxNewtonSteps && !None(active); ++step)
  {
    Point<T> residual;
    if (None(renew))
    {
      residual = Residual<Modes, Order>(problem, modeCount, y, state.xi);
    }
    else
    {
      Matrix<T> inverse;
      residual = ResidualAndInverse<Modes, Order>(problem, modeCount, y, state.xi, inverse);
      ForEachUpTo(Const<8>(),
        [&](auto k) PIXELEXACT_INLINED
        { state.inverse.m[k] = Select(renew, inverse.m[k], state.inverse.m[k]); });
    }
    Point<T> next = state.xi;
    const T length = Step<shape>(state.inverse, residual, next);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED { state.xi.x[d] = Select(active, next.x[d], state.xi.x[d]); });
    state.steps = Select(active, state.steps + one, state.steps);
    const auto lost = AndNot(active, IsSound(length, state.xi));
    state.failed = Select(lost, one, state.failed);
    const T scale = StepScale(shape, state.xi);
    madeFor = Select(renew, length, madeFor);
    const auto kept =
      And(madeFor <= keep * scale, Or(renew, length <= Traits::Splat(kContraction) * last));
    // The factor by which errors fall: of a new Jacobian the curvature times the step; of a kept
    // one what this step is of the last, if that is more than its own step promises.
    const T before = Select(renew, scale, last);
    const T promised = curvature * Select(renew, length, before * madeFor);
    const T rated = Select(renew, promised, Max(length, promised));
    const auto done = IsDone(length, rated, before, scale);
    last = Select(active, length, last);
    active = AndNot(AndNot(active, lost), done);
    renew = AndNot(active, kept);
  }
  state.madeFor = madeFor;
  if (!None(active))
  {
    // Where the Jacobian nearly vanishes steps do not get smaller than rounding.
    const auto rounding = last <= MaxAbs(ToleranceOf(state.inverse, problem.uncertainty));
    state.failed = Select(AndNot(active, rounding), one, state.failed);
    state.unsettled = Select(And(active, rounding), last, zero);
  }
}

/// Steps from state.xi until every lane is done or has failed. Mostly one is enough.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_INLINE void Iterate(
  const InverseProblem& problem, int modeCount, const Point<T>& y, NewtonState<T>& state)
{
  using Traits = NumberTraits<T>;
  constexpr Shape shape = Modes<T, Order, false>::kShape;
  const Point<T> residual =
    ResidualAndInverse<Modes, Order>(problem, modeCount, y, state.xi, state.inverse);
  const T length = Step<shape>(state.inverse, residual, state.xi);
  state.steps = Traits::Splat(1.0);
  state.madeFor = length;
  const T unit = StepScale(shape, state.xi);
  const auto done = IsDone(length, Traits::Splat(problem.curvature) * length, unit, unit);
  if (!All(And(done, IsSound(length, state.xi))))
  {
    // A copy, so that the state of those that are done need not be in memory.
    NewtonState<T> slow = state;
    GoOn<Modes, Order>(problem, modeCount, y, length, slow);
    state = slow;
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
