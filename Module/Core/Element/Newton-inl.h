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
/// A lane is done when its expected error is below the first, which the polishing step measures and
/// removes, and the error after polishing is expected to be below the second.
inline constexpr double kSmallError = 2e-11;
/// Both are overestimates: the remaining error is mostly rounding.
inline constexpr double kNoError = 1e-15;
/// A kept Jacobian is recomputed when a step is not smaller than the one before by this factor: a
/// new Jacobian costs as much as two steps with the old one.
inline constexpr double kContraction = 0.02;
inline constexpr int kMaxNewtonSteps = 24;
/// A root farther outside the shape cannot belong to the element; the careful path decides.
inline constexpr double kFarOut = 8.0;

/// The unit of a step's length. A pyramid's map bends on the scale of the distance to its apex, all
/// others on that of the shape.
template <class T>
HWY_INLINE T StepScale(Shape shape, const Point<T>& xi)
{
  const T one = NumberTraits<T>::Splat(1.0);
  return shape == Shape::Pyramid ? Min(one, NumberTraits<T>::Splat(0.5) * Abs(one - xi.x[2])) : one;
}

/// Next to its apex a pyramid's functions are constant past the faces (CollapsedQuotient), where an
/// iteration would not return. Moves xi to the point of the pyramid that has the same value.
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

/// Computes the residual and the Jacobian. The residual's bits are those of Residual.
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

/// Computes the residual and the inverse of the Jacobian.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_INLINE Point<T> ResidualAndInverse(const InverseProblem& problem, int modeCount,
  const Point<T>& y, const Point<T>& xi, Matrix<T>& inverse)
{
  Matrix<T> jacobian;
  const Point<T> residual = ResidualAndJacobian<Modes, Order>(problem, modeCount, y, xi, jacobian);
  inverse = Inverse(jacobian);
  return residual;
}

/// Subtracts delta from xi. Steps longer than the shape are shortened: far from the root only their
/// direction is useful. Returns the full step's length.
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

/// Takes one step from xi.
template <Shape kShape, class T>
HWY_INLINE T Step(const Matrix<T>& inverse, const Point<T>& residual, Point<T>& xi)
{
  return Move<kShape>(Apply(inverse, residual), xi);
}

/// Returns false for NaN, so that it ends as failed.
template <class T>
HWY_INLINE auto IsSound(const T& length, const Point<T>& xi)
{
  return And(length >= NumberTraits<T>::Splat(0.0), MaxAbs(xi) <= NumberTraits<T>::Splat(kFarOut));
}

/// Whether only polishing remains after a step of `length`, if steps fall to `rated` of `before`.
template <class T>
HWY_INLINE auto IsDone(const T& length, const T& rated, const T& before, const T& unit)
{
  using Traits = NumberTraits<T>;
  const T next = length * rated;
  return And(next <= Traits::Splat(kSmallError) * unit * before,
    next * rated <= Traits::Splat(kNoError) * unit * before * before);
}

/// Continues after a first step of length `first`. A lane depends on its own steps alone and keeps
/// its state when it is done, so that its result does not depend on the others.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_NOINLINE void GoOn(const InverseProblem& problem, int modeCount, const Point<T>& y,
  const T& first, NewtonState<T>& state)
{
  using Traits = NumberTraits<T>;
  constexpr Shape shape = Modes<T, Order, false>::kShape;
  const T zero = Traits::Splat(0.0);
  const T one = Traits::Splat(1.0);
  const T curvature = Traits::Splat(problem.curvature);
  // A Jacobian that gains too little per step costs more than its cheaper steps save.
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
    // The factor by which errors fall. A new Jacobian: the curvature times the step. A kept one:
    // the ratio of this step to the last, if that is larger.
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
    // Where the Jacobian nearly vanishes, steps stay as large as rounding.
    const auto rounding = last <= MaxAbs(ToleranceOf(state.inverse, problem.uncertainty));
    state.failed = Select(AndNot(active, rounding), one, state.failed);
    state.unsettled = Select(And(active, rounding), last, zero);
  }
}

/// Iterates from state.xi until every lane is done or has failed. One step is usually enough.
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
    // The copy lets the state of finished lanes stay in registers.
    NewtonState<T> slow = state;
    GoOn<Modes, Order>(problem, modeCount, y, length, slow);
    state = slow;
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
