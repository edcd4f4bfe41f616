// SPDX-License-Identifier: BSD-3-Clause
// The batch kernels as templates on a shape's Modes class and its order; see Kernels.h.
#if defined(PIXELEXACT_KERNELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_KERNELS_INL_H
#undef PIXELEXACT_KERNELS_INL_H
#else
#define PIXELEXACT_KERNELS_INL_H
#endif

#include "Core/Basis/Modes-inl.h"
#include "Core/Element/Kernels.h"
#include "Core/Element/Matrix-inl.h"
#include "Core/Element/Overflow-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Newton stops a lane when its step is below this: quadratic convergence makes the next error
/// about its square, and the polishing step after it is measured, not assumed.
inline constexpr double kSmallStep = 1e-7;
/// A polishing correction above this (and above the rounding tolerance) is no convergence.
inline constexpr double kLargestCorrection = 1e-10;
inline constexpr int kMaxNewtonSteps = 24;
/// A root farther out than this cannot be the element's; the careful path decides.
inline constexpr double kFarOut = 8.0;

HWY_INLINE Point<Lanes> LoadPoint(const LanePoints& points, int at)
{
  return { { Load(points.x[0] + at), Load(points.x[1] + at), Load(points.x[2] + at) } };
}

template <template <class, class, bool> class Modes, class Order>
void ValueKernel(const Space& space, const double* coefficients, int components,
  const LanePoints& xi, double* const* out)
{
  const int modeCount = components > 1 ? space.Modes() : 0;
  const int lanes = LaneCount();
  for (int i = 0; i < xi.count; i += lanes)
  {
    const Point<Lanes> at = LoadPoint(xi, i);
    const Modes<Lanes, Order, false> modes(space, at);
    for (int c = 0; c < components; ++c)
    {
      const double* component = coefficients + static_cast<std::ptrdiff_t>(c) * modeCount;
      Lanes value = modes.Value(component);
      if (HWY_UNLIKELY(!All(IsFinite(value))))
      {
        RescueValue<Modes>(space, component, at, value);
      }
      Store(value, out[c] + i);
    }
  }
}

template <template <class, class, bool> class Modes, class Order>
void GradientKernel(const Space& space, const double* coefficients, int components,
  const LanePoints& xi, double* const* out, double* const* gradient)
{
  const int modeCount = components > 1 ? space.Modes() : 0;
  const int lanes = LaneCount();
  for (int i = 0; i < xi.count; i += lanes)
  {
    const Point<Lanes> at = LoadPoint(xi, i);
    const Modes<Lanes, Order, true> modes(space, at);
    for (int c = 0; c < components; ++c)
    {
      const double* component = coefficients + static_cast<std::ptrdiff_t>(c) * modeCount;
      auto e = modes.Evaluate(component);
      const LaneMask finite = IsFinite(e.value + e.gradient[0] + e.gradient[1] + e.gradient[2]);
      if (HWY_UNLIKELY(!All(finite)))
      {
        RescueGradient<Modes>(space, component, at, finite, e);
      }
      Store(e.value, out[c] + i);
      for (int d = 0; d < 3; ++d)
      {
        Store(e.gradient[d], gradient[3 * c + d] + i);
      }
    }
  }
}

/// Signed distances to the faces; each widened by the tolerance t of the coordinates it is made of.
HWY_INLINE Lanes WidenedMargin(Shape shape, const Point<Lanes>& xi, const Point<Lanes>& t)
{
  const Lanes one = Splat(1.0);
  const Lanes zero = Splat(0.0);
  const Lanes low =
    Min(Min(one + xi.x[0] + t.x[0], one + xi.x[1] + t.x[1]), one + xi.x[2] + t.x[2]);
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

/// What a step's length is measured by. A pyramid's map bends on the scale of the distance to its
/// apex, all others on that of the shape.
HWY_INLINE Lanes StepScale(Shape shape, const Point<Lanes>& xi)
{
  const Lanes one = Splat(1.0);
  return shape == Shape::Pyramid ? Min(one, Splat(0.5) * Abs(one - xi.x[2])) : one;
}

/// Next to its apex a pyramid's functions are constant past the faces (CollapsedQuotient), and an
/// iteration that gets there does not come back. It goes on from the point that has the value.
HWY_INLINE void BackOntoCone(Point<Lanes>& xi)
{
  const Lanes zero = Splat(0.0);
  const Lanes one = Splat(1.0);
  const Lanes width = one - xi.x[2];
  const LaneMask close = Abs(width) < Splat(2e-8);
  for (int d = 0; d < 2; ++d)
  {
    const Lanes at = Max(Min(one + xi.x[d], Max(width, zero)), Min(width, zero));
    xi.x[d] = Select(close, at - one, xi.x[d]);
  }
}

struct NewtonState
{
  Point<Lanes> xi;
  Matrix inverse; ///< of the last Jacobian
  Lanes failed;   ///< 1 where the iteration gave up, else 0
  Lanes steps;
  Lanes unsettled; ///< the last step, where steps do not get smaller, else 0
};

/// Full Newton steps until every lane is at kSmallStep or has failed. Lanes that are done keep
/// their state, so that a lane's result does not depend on the others.
template <template <class, class, bool> class Modes, class Order>
HWY_INLINE NewtonState Iterate(
  const InverseProblem& problem, int modeCount, const Point<Lanes>& y, Point<Lanes> xi)
{
  const Lanes zero = Splat(0.0);
  const Lanes one = Splat(1.0);
  NewtonState state{ xi, {}, zero, zero, zero };
  LaneMask active = zero <= zero;
  Lanes last = one;
  for (int step = 0; step < kMaxNewtonSteps && !None(active); ++step)
  {
    const Modes<Lanes, Order, true> modes(problem.space, state.xi);
    Matrix jacobian;
    Point<Lanes> residual;
    for (int c = 0; c < 3; ++c)
    {
      const auto e =
        modes.Evaluate(problem.coefficients + static_cast<std::ptrdiff_t>(c) * modeCount);
      residual.x[c] = e.value - y.x[c];
      for (int d = 0; d < 3; ++d)
      {
        jacobian.m[3 * c + d] = e.gradient[d];
      }
    }
    const Matrix inverse = Inverse(jacobian);
    const Point<Lanes> delta = Apply(inverse, residual);
    const Lanes length = MaxAbs(delta);
    last = Select(active, length, last);
    state.steps = Select(active, state.steps + one, state.steps);
    // Steps longer than the shape are shortened: far from the root they say no more than a
    // direction.
    const Lanes scale = Select(length <= one, one, one / length);
    Point<Lanes> next;
    for (int d = 0; d < 3; ++d)
    {
      next.x[d] = NegMulAdd(scale, delta.x[d], state.xi.x[d]);
    }
    const bool pyramid = problem.space.shape == Shape::Pyramid;
    if (pyramid)
    {
      BackOntoCone(next);
    }
    for (int d = 0; d < 3; ++d)
    {
      state.xi.x[d] = Select(active, next.x[d], state.xi.x[d]);
    }
    for (int k = 0; k < 9; ++k)
    {
      state.inverse.m[k] = Select(active, inverse.m[k], state.inverse.m[k]);
    }
    // A NaN compares false and so ends as failed.
    const LaneMask sound = And(length >= zero, MaxAbs(state.xi) <= Splat(kFarOut));
    const LaneMask lost = AndNot(active, sound);
    state.failed = Select(lost, one, state.failed);
    const Lanes small = Splat(kSmallStep) * StepScale(problem.space.shape, state.xi);
    active = AndNot(AndNot(active, lost), length <= small);
  }
  if (!None(active))
  {
    // Where the Jacobian nearly vanishes steps do not get smaller than rounding.
    const LaneMask rounding = last <= MaxAbs(ToleranceOf(state.inverse, problem.uncertainty));
    state.failed = Select(AndNot(active, rounding), one, state.failed);
    state.unsettled = Select(And(active, rounding), last, zero);
  }
  return state;
}

template <template <class, class, bool> class Modes, class Order>
void InvertKernel(const InverseProblem& problem, const LanePoints& x, const InverseResult& out)
{
  const int modeCount = problem.space.Modes();
  const int lanes = LaneCount();
  const Lanes zero = Splat(0.0);
  Matrix frame;
  for (int k = 0; k < 9; ++k)
  {
    frame.m[k] = Splat(problem.inverse[k]);
  }
  for (int i = 0; i < x.count; i += lanes)
  {
    Point<Lanes> y;
    Point<Lanes> fromOrigin;
    for (int d = 0; d < 3; ++d)
    {
      y.x[d] = (Load(x.x[d] + i) - Splat(problem.centre[d])) * Splat(problem.inverseSize);
      fromOrigin.x[d] = y.x[d] - Splat(problem.origin[d]);
    }
    Point<Lanes> start = Apply(frame, fromOrigin);
    for (int d = 0; d < 3; ++d)
    {
      start.x[d] = start.x[d] + Splat(problem.start[d]);
    }
    NewtonState state{ start, frame, zero, zero, zero };
    if (!problem.affine)
    {
      for (int d = 0; d < 3; ++d)
      {
        start.x[d] = Max(Min(start.x[d], Splat(1.0)), Splat(-1.0));
      }
      state = Iterate<Modes, Order>(problem, modeCount, y, start);
    }
    // Polish with the last Jacobian. The correction is the measured residual of the iteration.
    const Modes<Lanes, Order, false> modes(problem.space, state.xi);
    Point<Lanes> residual;
    for (int c = 0; c < 3; ++c)
    {
      residual.x[c] =
        modes.Value(problem.coefficients + static_cast<std::ptrdiff_t>(c) * modeCount) - y.x[c];
    }
    const Point<Lanes> correction = Apply(state.inverse, residual);
    const Point<Lanes> tolerance = ToleranceOf(state.inverse, problem.uncertainty);
    for (int d = 0; d < 3; ++d)
    {
      state.xi.x[d] = state.xi.x[d] - correction.x[d];
    }
    const Lanes length = MaxAbs(correction);
    const Lanes largest = Splat(kLargestCorrection) * StepScale(problem.space.shape, state.xi);
    LaneMask converged =
      And(state.failed <= zero, length <= Max(largest, Splat(4.0) * MaxAbs(tolerance)));
    const Point<Lanes> none{ { zero, zero, zero } };
    const Lanes margin = WidenedMargin(problem.space.shape, state.xi, none);
    const LaneMask within = WidenedMargin(problem.space.shape, state.xi, tolerance) >= zero;
    // Outside is said where it does not matter that the iteration has not settled.
    Point<Lanes> reach;
    for (int d = 0; d < 3; ++d)
    {
      reach.x[d] = MulAdd(Splat(4.0), state.unsettled, tolerance.x[d]);
    }
    const LaneMask near = WidenedMargin(problem.space.shape, state.xi, reach) >= zero;
    converged = AndNot(converged, AndNot(near, within));
    if (problem.space.shape == Shape::Pyramid)
    {
      converged = AndNot(converged, Abs(Splat(1.0) - state.xi.x[2]) <= Splat(kApexRegion));
    }
    const LaneMask inside = And(converged, within);
    for (int d = 0; d < 3; ++d)
    {
      Store(state.xi.x[d], out.xi[d] + i);
    }
    Store(Select(inside, Splat(1.0), Select(converged, zero, Splat(2.0))), out.status + i);
    Store(margin, out.margin + i);
    Store(length, out.residual + i);
    if (out.steps)
    {
      Store(state.steps, out.steps + i);
    }
  }
}

template <template <class, class, bool> class Modes, class Order>
KernelSet MakeKernelSet()
{
  return { &ValueKernel<Modes, Order>, &GradientKernel<Modes, Order>, &InvertKernel<Modes, Order> };
}

/// Kernels with the order compiled in for the usual uniform orders, generic ones above.
template <template <class, class, bool> class Modes, int... kOrders>
KernelSet SelectKernelSet(const Space& space)
{
  KernelSet set = MakeKernelSet<Modes, AnyOrder>();
  const auto [p, q, r] = space.order;
  if (p == q && q == r)
  {
    (void)((p == kOrders ? (set = MakeKernelSet<Modes, FixedOrder<kOrders>>(), true) : false) ||
      ...);
  }
  return set;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
