// SPDX-License-Identifier: BSD-3-Clause
// Newton's iteration for Phi(xi) = y, many points of one element at a time, and what its result
// says of the shape; see Kernels.h. T is Lanes.
#if defined(PIXELEXACT_NEWTON_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_NEWTON_INL_H
#undef PIXELEXACT_NEWTON_INL_H
#else
#define PIXELEXACT_NEWTON_INL_H
#endif

#include "Core/Element/Guess-inl.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/Matrix-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A lane is done when its next error is expected to be below the first, which the polishing step
/// measures and takes away, and what polishing leaves below the second.
inline constexpr double kSmallError = 2e-11;
inline constexpr double kNoError = 1e-17;
/// A kept Jacobian is made anew when a step is not this much smaller than the one before.
inline constexpr double kContraction = 0.1;
/// A polishing correction above this (and above the rounding tolerance) is no convergence.
inline constexpr double kLargestCorrection = 1e-10;
inline constexpr int kMaxNewtonSteps = 24;
/// A xi that lies farther beyond a face than this is not taken for one of the shape, however large
/// the tolerance: the map is not known to be what is evaluated there, nor is the field.
inline constexpr double kFarBeyond = 1e-2;
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
  // A Jacobian that gains no digit a step is not worth its cheaper steps.
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

/// x with A x = b, by elimination with pivoting.
template <class T>
HWY_NOINLINE Point<T> Solve(Matrix<T> a, Point<T> b)
{
  for (int k = 0; k < 3; ++k)
  {
    for (int i = k + 1; i < 3; ++i)
    {
      const auto swap = Abs(a.m[3 * k + k]) < Abs(a.m[3 * i + k]);
      for (int j = 0; j < 3; ++j)
      {
        const T upper = a.m[3 * k + j];
        a.m[3 * k + j] = Select(swap, a.m[3 * i + j], upper);
        a.m[3 * i + j] = Select(swap, upper, a.m[3 * i + j]);
      }
      const T upper = b.x[k];
      b.x[k] = Select(swap, b.x[i], upper);
      b.x[i] = Select(swap, upper, b.x[i]);
    }
    for (int i = k + 1; i < 3; ++i)
    {
      const T factor = a.m[3 * i + k] / a.m[3 * k + k];
      for (int j = k + 1; j < 3; ++j)
      {
        a.m[3 * i + j] = a.m[3 * i + j] - factor * a.m[3 * k + j];
      }
      b.x[i] = b.x[i] - factor * b.x[k];
    }
  }
  for (int k = 2; k >= 0; --k)
  {
    for (int j = k + 1; j < 3; ++j)
    {
      b.x[k] = b.x[k] - a.m[3 * k + j] * b.x[j];
    }
    b.x[k] = b.x[k] / a.m[3 * k + k];
  }
  return b;
}

/// A step that follows the residual in the directions alone in which the map moves: J^T z with
/// (J J^T + l^2) z = residual (K. Levenberg, 1944). Where the Jacobian nearly vanishes, Newton's
/// own step is the rounding of the residual, magnified; of a thin and bent element it leads off the
/// point along the others.
template <class T>
HWY_NOINLINE Point<T> DampedStep(const Matrix<T>& jacobian, const Point<T>& residual)
{
  constexpr double kDamping = 1e-12; // l^2, of the trace
  const auto& m = jacobian.m;
  Matrix<T> square;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      square.m[3 * i + j] =
        MulAdd(m[3 * i], m[3 * j], MulAdd(m[3 * i + 1], m[3 * j + 1], m[3 * i + 2] * m[3 * j + 2]));
    }
  }
  const T damping = NumberTraits<T>::Splat(kDamping) * (square.m[0] + square.m[4] + square.m[8]);
  for (int i = 0; i < 3; ++i)
  {
    square.m[4 * i] = square.m[4 * i] + damping;
  }
  const Point<T> z = Solve(square, residual);
  Point<T> step;
  for (int j = 0; j < 3; ++j)
  {
    step.x[j] = MulAdd(m[j], z.x[0], MulAdd(m[3 + j], z.x[1], m[6 + j] * z.x[2]));
  }
  return step;
}

/// The verdicts on a pack of which not every lane is simply inside.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_NOINLINE void Judge(const InverseProblem& problem, int modeCount, const Point<T>& y,
  const NewtonState<T>& polished, const Point<T>& before, const Point<T>& missBefore,
  const T& length, const InverseResult& out, int at)
{
  NewtonState<T> state = polished;
  using Traits = NumberTraits<T>;
  constexpr Shape kShape = Modes<T, Order, false>::kShape;
  const T zero = Traits::Splat(0.0);
  auto holds = length >= zero;
  if (!problem.affine)
  {
    // A xi is not taken for a preimage on the word of a Jacobian alone. Where the Jacobian nearly
    // vanishes, the last correction may lead away from one.
    const auto isSmall = [&](const Point<T>& miss) PIXELEXACT_INLINED
    {
      auto small = length >= zero;
      ForEachAxis(
        [&](auto c) PIXELEXACT_INLINED {
          small = And(small, Abs(miss.x[c]) <= Traits::Splat(kMostMiss * problem.uncertainty[c]));
        });
      return small;
    };
    const auto polishedHolds = isSmall(Residual<Modes, Order>(problem, modeCount, y, polished.xi));
    const auto back = AndNot(isSmall(missBefore), polishedHolds);
    holds = Or(polishedHolds, back);
    const auto take = [&](const auto& lanes, const Point<T>& xi) PIXELEXACT_INLINED
    {
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED { state.xi.x[d] = Select(lanes, xi.x[d], state.xi.x[d]); });
    };
    take(back, before);
    // Nor need the next one be a preimage; some step often is. What gave up stays unknown.
    Point<T> next = state.xi;
    const auto lost = zero < state.failed;
    constexpr int kMoreSteps = 8;
    for (int step = 0; step < kMoreSteps && !All(Or(holds, lost)); ++step)
    {
      Matrix<T> jacobian;
      const Point<T> miss =
        ResidualAndJacobian<Modes, Order>(problem, modeCount, y, next, jacobian);
      const Matrix<T> inverse = Inverse(jacobian);
      const auto found = AndNot(isSmall(miss), holds);
      take(found, next);
      ForEachUpTo(Const<8>(),
        [&](auto k) PIXELEXACT_INLINED
        { state.inverse.m[k] = Select(found, inverse.m[k], state.inverse.m[k]); });
      holds = Or(holds, found);
      Move<kShape>(DampedStep(jacobian, miss), next);
    }
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { Store(state.xi.x[d], out.xi[d] + at); });
  }
  const Point<T> tolerance = ToleranceOf(state.inverse, problem.uncertainty);
  const T largest = Traits::Splat(kLargestCorrection) * StepScale(kShape, state.xi);
  auto converged =
    And(state.failed <= zero, length <= Max(largest, Traits::Splat(4.0) * MaxAbs(tolerance)));
  Point<T> reach;
  ForEachAxis([&](auto d) PIXELEXACT_INLINED
    { reach.x[d] = Min(tolerance.x[d], Traits::Splat(kFarBeyond)); });
  const auto near = WidenedMargin(kShape, state.xi, tolerance) >= zero;
  const auto within = And(near, WidenedMargin(kShape, state.xi, reach) >= zero);
  converged = AndNot(converged, AndNot(near, within));
  if (HWY_UNLIKELY(!All(state.unsettled <= zero)))
  {
    // Outside is said where it does not matter that the iteration has not settled.
    ForEachAxis([&](auto d) PIXELEXACT_INLINED
      { reach.x[d] = MulAdd(Traits::Splat(4.0), state.unsettled, tolerance.x[d]); });
    const auto perhaps = WidenedMargin(kShape, state.xi, reach) >= zero;
    converged = AndNot(converged, AndNot(perhaps, within));
  }
  if (kShape == Shape::Pyramid)
  {
    converged =
      AndNot(converged, Abs(Traits::Splat(1.0) - state.xi.x[2]) <= Traits::Splat(kApexRegion));
  }
  converged = AndNot(converged, AndNot(within, holds));
  const auto inside = And(converged, within);
  const Point<T> none{ { zero, zero, zero } };
  Store(Select(inside, zero, WidenedMargin(kShape, state.xi, none)), out.margin + at);
  Store(Select(inside, Traits::Splat(1.0), Select(converged, zero, Traits::Splat(2.0))),
    out.status + at);
}

/// What is known of Count() points from `at` on.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_INLINE void InvertPack(const InverseProblem& problem, int modeCount, const LanePoints& x,
  const InverseResult& out, int at)
{
  using Traits = NumberTraits<T>;
  constexpr Shape shape = Modes<T, Order, false>::kShape;
  const T zero = Traits::Splat(0.0);
  const T one = Traits::Splat(1.0);
  Matrix<T> frame;
  ForEachUpTo(
    Const<8>(), [&](auto k) PIXELEXACT_INLINED { frame.m[k] = Traits::Splat(problem.inverse[k]); });
  Point<T> y;
  Point<T> fromOrigin;
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      y.x[d] = (Traits::Load(x.x[d] + at) - Traits::Splat(problem.centre[d])) *
        Traits::Splat(problem.inverseSize);
      fromOrigin.x[d] = y.x[d] - Traits::Splat(problem.origin[d]);
    });
  Point<T> start = Apply(frame, fromOrigin);
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED { start.x[d] = start.x[d] + Traits::Splat(problem.start[d]); });
  NewtonState<T> state{ start, frame, zero, zero, zero, zero };
  if (!problem.affine)
  {
    if (problem.from[0])
    {
      start = { { Traits::Load(problem.from[0] + at), Traits::Load(problem.from[1] + at),
        Traits::Load(problem.from[2] + at) } };
    }
    else if (problem.guess)
    {
      start = Guess(problem, start);
    }
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED { state.xi.x[d] = Max(Min(start.x[d], one), zero - one); });
    Iterate<Modes, Order>(problem, modeCount, y, state);
  }
  // Polish with the last Jacobian. The correction is the measured residual of the iteration.
  const Point<T> residual = Residual<Modes, Order>(problem, modeCount, y, state.xi);
  const Point<T> correction = Apply(state.inverse, residual);
  const Point<T> before = state.xi;
  ForEachAxis([&](auto d) PIXELEXACT_INLINED { state.xi.x[d] = before.x[d] - correction.x[d]; });
  const T length = MaxAbs(correction);
  ForEachAxis([&](auto d) PIXELEXACT_INLINED { Store(state.xi.x[d], out.xi[d] + at); });
  Store(length, out.residual + at);
  if (out.steps)
  {
    Store(state.steps, out.steps + at);
  }
  const double leastUncertainty =
    std::min({ problem.uncertainty[0], problem.uncertainty[1], problem.uncertainty[2] });
  // Within the shape without any tolerance, as most are; NaN are not.
  const Point<T> none{ { zero, zero, zero } };
  const T unit = StepScale(shape, state.xi);
  auto clear = And(length <= Traits::Splat(kLargestCorrection) * unit,
    WidenedMargin(shape, state.xi, none) >= zero);
  clear = And(clear, Max(state.failed, state.unsettled) <= zero);
  // What the correction leaves: the Jacobian's change since it was made, times the correction.
  const T left =
    Traits::Splat(problem.bend) * (Traits::Splat(2.0) * state.madeFor + length) * length;
  const T reach = problem.space.form == Form::Tensor ? unit * unit : unit;
  clear = And(clear,
    And(left <= Traits::Splat(leastUncertainty) * reach,
      state.madeFor <= Traits::Splat(kKeepJacobian) * unit));
  if (shape == Shape::Pyramid)
  {
    clear = And(clear, Traits::Splat(kApexRegion) < one - state.xi.x[2]);
  }
  if (HWY_LIKELY(All(clear)))
  {
    Store(one, out.status + at);
    Store(zero, out.margin + at);
  }
  else
  {
    // Copies, so that what most packs need stays in registers.
    const NewtonState<T> judged = state;
    const Point<T> unpolished = before;
    const Point<T> miss = residual;
    Judge<Modes, Order>(problem, modeCount, y, judged, unpolished, miss, length, out, at);
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
