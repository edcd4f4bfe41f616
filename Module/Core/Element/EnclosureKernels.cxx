// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/EnclosureKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/BallMapping-inl.h"
#include "Core/Element/KrawczykOperator-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The first box. Curvature contributes little at this size, and rounding of Phi less.
inline constexpr double kFirstRadius = 0x1p-32;
/// The first box where even a Newton step from kFirstRadius is unbounded, near a pyramid's apex.
inline constexpr double kSmallRadius = 0x1p-48;
inline constexpr int kMaxBoxes = 3;
inline constexpr int kMaxInflations = 4;
/// Mapped vectors have three components.
inline constexpr int kComponentsAtOnce = 3;

/// Encloses the preimages: xi0 + deviation, within `radius` of xi0.
struct PreimageBox
{
  Point<Ball> deviation;
  Point<Lanes> radius;
};

/// Krawczyk's test for one pack of points.
class KrawczykTest
{
public:
  HWY_INLINE KrawczykTest(
    const EnclosureTask& task, const BallKernels& kernels, const Point<Lanes>& xi)
    : Operator(task, kernels, xi)
  {
  }

  /// Returns infinite boxes for lanes that could not be proven.
  HWY_INLINE PreimageBox Run(const Point<Lanes>& x)
  {
    const Lanes infinity = Splat(std::numeric_limits<double>::infinity());
    const Lanes zero = Splat(0.0);
    Operator.Evaluate(x);
    PreimageBox box;
    Point<Lanes> size;
    for (int d = 0; d < 3; ++d)
    {
      box.deviation.x[d] = { zero, infinity };
      box.radius.x[d] = infinity;
      size.x[d] = Splat(kFirstRadius);
    }
    LaneMask open = zero <= zero;
    for (int k = 0; k < kMaxBoxes && !None(open); ++k)
    {
      Operator.Linearise(size);
      open = AndNot(open, Contract(size, open, box));
      const Lanes step = Splat(8.0) *
        Max(Max(Operator.Step.x[0].Magnitude(), Operator.Step.x[1].Magnitude()),
          Operator.Step.x[2].Magnitude());
      for (int d = 0; d < 3; ++d)
      {
        const Lanes own = Max(Splat(8.0) * Operator.Step.x[d].Magnitude(), Splat(0x1p-20) * step);
        size.x[d] = Select(step < infinity, own, Splat(kSmallRadius));
      }
    }
    return box;
  }

private:
  /// Searches for a box within `size` that the operator K proves, and enlarges it to K's image
  /// where that fails. Returns the lanes with such a box; `box` changes in these alone.
  HWY_INLINE LaneMask Contract(const Point<Lanes>& size, LaneMask open, PreimageBox& box)
  {
    Point<Lanes> rho;
    for (int d = 0; d < 3; ++d)
    {
      rho.x[d] = Splat(2.0) * Operator.Step.x[d].Magnitude();
    }
    LaneMask found = AndNot(open, open);
    for (int inflation = 0; inflation < kMaxInflations && !None(AndNot(open, found)); ++inflation)
    {
      LaneMask proven = AndNot(open, found);
      const Point<Lanes> spread = Operator.Spread(rho);
      Point<Lanes> reach;
      for (int i = 0; i < 3; ++i)
      {
        reach.x[i] = ball::RoundUp(Operator.Step.x[i].Magnitude() + spread.x[i]);
        proven = And(proven, And(reach.x[i] < rho.x[i], rho.x[i] <= size.x[i]));
      }
      for (int i = 0; i < 3; ++i)
      {
        const Ball& step = Operator.Step.x[i];
        Ball& deviation = box.deviation.x[i];
        deviation.middle = Select(proven, Splat(0.0) - step.middle, deviation.middle);
        deviation.radius =
          Select(proven, ball::RoundUp(step.radius + spread.x[i]), deviation.radius);
        box.radius.x[i] = Select(proven, reach.x[i], box.radius.x[i]);
        rho.x[i] = Splat(2.0) * reach.x[i];
      }
      found = Or(found, proven);
    }
    return found;
  }

  KrawczykOperator Operator;
};

/// Encloses some of the field's components over one pack's box, by the mean value form or directly,
/// whichever is narrower, and their derivatives by xi.
void EncloseField(const EnclosureTask& task, const BallKernels& kernels, const Point<Lanes>& xi,
  const PreimageBox& box, int first, int count, Ball* value, Ball* gradient)
{
  const double* coefficients =
    task.coefficients + static_cast<std::ptrdiff_t>(first) * task.space.Modes();
  Ball direct[kComponentsAtOnce];
  const Lanes zero = Splat(0.0);
  kernels.values(task.space, coefficients, count, BoxAround(xi, { { zero, zero, zero } }), value);
  kernels.gradients(task.space, coefficients, count, BoxAround(xi, box.radius), direct, gradient);
  for (int c = 0; c < count; ++c)
  {
    for (int d = 0; d < 3; ++d)
    {
      value[c] = MulAdd(gradient[3 * c + d], box.deviation.x[d], value[c]);
    }
    const LaneMask narrower = direct[c].radius < value[c].radius;
    value[c] = { Select(narrower, direct[c].middle, value[c].middle),
      Select(narrower, direct[c].radius, value[c].radius) };
  }
}

void EnclosePacks(const EnclosureTask& task, const LanePoints& xi, const LanePoints& x,
  const BallArrays& values, const BallArrays& gradients)
{
  const BallKernels mapKernels = BallKernelsFor(task.mapSpace);
  const BallKernels kernels = BallKernelsFor(task.space);
  const Lanes infinity = Splat(std::numeric_limits<double>::infinity());
  const int lanes = LaneCount();
  for (int i = 0; i < xi.count; i += lanes)
  {
    const Point<Lanes> at = LoadPoint<Lanes>(xi, i);
    const PreimageBox box = KrawczykTest(task, mapKernels, at).Run(LoadPoint<Lanes>(x, i));
    const LaneMask proven = box.radius.x[0] < infinity;
    Ball jacobian[9];
    if (task.mapping != Mapping::Identity || gradients.middle != nullptr)
    {
      Ball phi[3];
      mapKernels.gradients(
        task.mapSpace, task.mapCoefficients, 3, BoxAround(at, box.radius), phi, jacobian);
    }
    for (int first = 0; first < task.components; first += kComponentsAtOnce)
    {
      Ball value[kComponentsAtOnce];
      Ball gradient[3 * kComponentsAtOnce];
      const int count = std::min(task.components - first, kComponentsAtOnce);
      EncloseField(task, kernels, at, box, first, count, value, gradient);
      if (task.mapping != Mapping::Identity)
      {
        MapBalls(task.mapping, jacobian, count, value);
      }
      for (int c = 0; c < count; ++c)
      {
        Store(value[c].middle, values.middle[first + c] + i);
        // A constant has a known value everywhere, but the preimage must be proven.
        Store(Select(proven, value[c].radius, infinity), values.radius[first + c] + i);
      }
      for (int c = 0; gradients.middle != nullptr && c < count; ++c)
      {
        // du / dx = J^-T du / dxi, as for a covariant field.
        Ball* const slope = gradient + 3 * c;
        MapBalls(Mapping::Covariant, jacobian, 3, slope);
        for (int d = 0; d < 3; ++d)
        {
          const int k = 3 * (first + c) + d;
          Store(slope[d].middle, gradients.middle[k] + i);
          Store(Select(proven, slope[d].radius, infinity), gradients.radius[k] + i);
        }
      }
    }
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(EnclosePacks);

void EncloseInLanes(const EnclosureTask& task, const LanePoints& xi, const LanePoints& x,
  const BallArrays& values, const BallArrays& gradients)
{
  HWY_DYNAMIC_DISPATCH(EnclosePacks)(task, xi, x, values, gradients);
}
} // namespace pixelexact
#endif
