// SPDX-License-Identifier: BSD-3-Clause
// The inverse map of many points of one element at a time, and the classification of its results
// as inside or outside the shape; see Kernels.h. T is Lanes.
#if defined(PIXELEXACT_PREIMAGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PREIMAGE_INL_H
#undef PIXELEXACT_PREIMAGE_INL_H
#else
#define PIXELEXACT_PREIMAGE_INL_H
#endif

#include "Core/Element/Guess-inl.h"
#include "Core/Element/Newton-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A polishing correction above this (and above the rounding tolerance) means no convergence.
inline constexpr double kLargestCorrection = 1e-10;
/// A xi farther outside a face is never accepted, however large the tolerance: neither map nor
/// field is known there.
inline constexpr double kFarBeyond = 1e-2;

/// Solves A x = b by elimination with pivoting.
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

/// A step that follows the residual only in the directions in which the map moves: J^T z with (J
/// J^T + l^2) z = residual (K. Levenberg, 1944). Where the Jacobian nearly vanishes, Newton's own
/// step magnifies the rounding of the residual; in a thin and bent element it leaves the point
/// along the other directions.
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

/// Classifies a pack in which some lane is not clearly inside.
template <template <class, class, bool> class Modes, class Order, class T>
HWY_NOINLINE void Classify(const InverseProblem& problem, int modeCount, const Point<T>& y,
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
    // The Jacobian alone does not prove a preimage. Where it nearly vanishes, the last correction
    // may lead away from one.
    const auto isSmall = [&](const Point<T>& miss) PIXELEXACT_INLINED
    {
      auto small = length >= zero;
      ForEachAxis(
        [&](auto c) PIXELEXACT_INLINED {
          small = And(small, Abs(miss.x[c]) <= Traits::Splat(kMaxMiss * problem.uncertainty[c]));
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
    // The next xi may not be a preimage; one after a few steps often is. Lanes that failed stay
    // unknown.
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
    // A point is outside only where the unsettled steps cannot change that.
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

/// Inverts the map for Count() points from `at` on.
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
  // Polishes with the last Jacobian. The correction is the measured residual of the iteration.
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
  // Whether the lane is within the shape without any tolerance, as most are. NaN is not.
  const Point<T> none{ { zero, zero, zero } };
  const T unit = StepScale(shape, state.xi);
  auto clear = And(length <= Traits::Splat(kLargestCorrection) * unit,
    WidenedMargin(shape, state.xi, none) >= zero);
  clear = And(clear, Max(state.failed, state.unsettled) <= zero);
  // Bounds the error after the correction: the Jacobian's change since it was computed, times the
  // correction.
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
    // Copies let the data that most packs need stay in registers.
    const NewtonState<T> classified = state;
    const Point<T> unpolished = before;
    const Point<T> miss = residual;
    Classify<Modes, Order>(problem, modeCount, y, classified, unpolished, miss, length, out, at);
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
