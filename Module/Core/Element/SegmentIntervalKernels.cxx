// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Element/SegmentIntervalKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/BallMapping-inl.h"
#include "Core/Element/KrawczykOperator-inl.h"
#include "Core/Element/SegmentInterval.h"

#include <limits>

// The points of a segment are y(s) = y_m + (2 s - 1) h, so that with r = Phi(xi0) - y_m their
// preimages in a box X are
//   xi(s) in xi0 - C r + (2 s - 1) C h + (I - C J(X)) (X - xi0),
// and K, the hull over all s, proves them as it proves those of a point. All but the last term is a
// straight line, whose ends are those of the segment up to the error of the given xi. The shape is
// convex, so that the preimages leave it by at most that error and the last term.
HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The half width of the first box along each direction: kOwnShare times half of the ends'
/// distance, plus kLargestShare times the largest of these for the bend of the line where the ends
/// agree, plus kMinRadius for the error of the ends' xi.
inline constexpr double kOwnShare = 1.25;
inline constexpr double kLargestShare = 0.125;
inline constexpr double kMinRadius = 0x1p-32;
/// Each box is four times as large as the one before.
inline constexpr int kSegmentBoxes = 3;
inline constexpr double kGrowth = 4.0;

/// A box around xi0 that holds the segment's preimages, and the deviation of their line in it.
struct SegmentBox
{
  Point<Lanes> radius; ///< infinite where nothing is proven
  Point<Lanes> stray;  ///< as in SegmentsInLanes
  Lanes tolerance;
};

SegmentBox BoxOfSegments(const EnclosureTask& task, const BallKernels& kernels,
  const ElementSegments& segments, int i, Point<Lanes>& xi)
{
  const Lanes infinity = Splat(std::numeric_limits<double>::infinity());
  const Lanes half = Splat(0.5);
  const auto xiFrom = LoadPoint<Lanes>(segments.xiFrom, i);
  const auto xiTo = LoadPoint<Lanes>(segments.xiTo, i);
  Point<Lanes> size;
  for (int d = 0; d < 3; ++d)
  {
    xi.x[d] = half * (xiFrom.x[d] + xiTo.x[d]);
    size.x[d] = half * Abs(xiTo.x[d] - xiFrom.x[d]);
  }
  const Lanes largest = MulAdd(Splat(kLargestShare), MaxAbs(size), Splat(kMinRadius));
  for (int d = 0; d < 3; ++d)
  {
    size.x[d] = MulAdd(Splat(kOwnShare), size.x[d], largest);
  }

  KrawczykOperator krawczyk(task, kernels, xi);
  const auto from = LoadPoint<Lanes>(segments.from, i);
  const auto to = LoadPoint<Lanes>(segments.to, i);
  krawczyk.Evaluate(from);
  const Lanes slack = segments.slack
    ? ball::RoundUp(NumberTraits<Lanes>::Load(segments.slack + i) * Splat(task.inverseSize))
    : Splat(0.0);
  Ball h[3];
  for (int d = 0; d < 3; ++d)
  {
    const Lanes difference = half * (to.x[d] - from.x[d]) * Splat(task.inverseSize);
    h[d] = ball::Sum(difference, Splat(ball::kTiny));
    krawczyk.Residual.x[d] = krawczyk.Residual.x[d] - h[d] - Ball::AroundZero(slack);
  }

  const Point<Lanes> nothing{ { infinity, infinity, infinity } };
  SegmentBox box{ nothing, nothing, Splat(0.0) };
  LaneMask open = half <= half;
  for (int k = 0; k < kSegmentBoxes && !None(open); ++k)
  {
    krawczyk.Linearise(size);
    const Point<Ball> along = krawczyk.Solved(h);
    Point<Lanes> straight;
    Point<Lanes> reach;
    LaneMask proven = open;
    Point<Lanes> bend = krawczyk.Spread(size);
    for (int d = 0; d < 3; ++d)
    {
      straight.x[d] = ball::RoundUp(krawczyk.Step.x[d].Magnitude() + along.x[d].Magnitude());
      reach.x[d] = ball::RoundUp(straight.x[d] + bend.x[d]);
      proven = And(proven, reach.x[d] < size.x[d]);
    }
    // Repeats the step from the proven box.
    bend = krawczyk.Spread(reach);
    Lanes tolerance = Splat(0.0);
    for (int d = 0; d < 3; ++d)
    {
      const Lanes middle = xi.x[d] - krawczyk.Step.x[d].middle;
      const Lanes off = Max(Abs(xiFrom.x[d] - (middle - along.x[d].middle)),
        Abs(xiTo.x[d] - (middle + along.x[d].middle)));
      tolerance = tolerance + krawczyk.Step.x[d].radius;
      box.stray.x[d] = Select(proven, ball::RoundUp(bend.x[d] + off), box.stray.x[d]);
      const Lanes radius = ball::RoundUp(straight.x[d] + bend.x[d]);
      box.radius.x[d] = Select(proven, radius, box.radius.x[d]);
      size.x[d] = Splat(kGrowth) * size.x[d];
    }
    box.tolerance = Select(proven, tolerance, box.tolerance);
    open = AndNot(open, proven);
  }
  return box;
}

void EncloseSegmentPacks(
  const EnclosureTask& task, const ElementSegments& segments, const SegmentsInLanes& out)
{
  const BallKernels mapKernels = BallKernelsFor(task.mapSpace);
  const BallKernels kernels = BallKernelsFor(task.space);
  const Lanes infinity = Splat(std::numeric_limits<double>::infinity());
  const int lanes = LaneCount();
  const bool mixes = task.mapping == Mapping::Covariant || task.mapping == Mapping::Contravariant;
  // A mapping mixes three components.
  const int atOnce = mixes ? 3 : 1;
  for (int i = 0; i < segments.from.count; i += lanes)
  {
    Point<Lanes> xi;
    const SegmentBox box = BoxOfSegments(task, mapKernels, segments, i, xi);
    const LaneMask proven = box.radius.x[0] < infinity;
    const Point<Ball> around = BoxAround(xi, box.radius);
    Ball jacobian[9];
    if (task.mapping != Mapping::Identity)
    {
      Ball phi[3];
      mapKernels.gradients(task.mapSpace, task.mapCoefficients, 3, around, phi, jacobian);
    }
    for (int first = 0; first < task.components; first += atOnce)
    {
      Ball value[3];
      kernels.plainValues(task.space,
        task.coefficients + static_cast<std::ptrdiff_t>(first) * task.space.Modes(), atOnce, around,
        value);
      if (task.mapping != Mapping::Identity)
      {
        MapBalls(task.mapping, jacobian, atOnce, value);
      }
      for (int c = 0; c < atOnce; ++c)
      {
        Store(value[c].middle, out.middle[first + c] + i);
        Store(Select(proven, value[c].radius, infinity), out.radius[first + c] + i);
      }
    }
    for (int d = 0; d < 3; ++d)
    {
      Store(box.stray.x[d], out.stray[d] + i);
    }
    Store(box.tolerance, out.tolerance + i);
  }
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(EncloseSegmentPacks);

void EncloseSegmentsInLanes(
  const EnclosureTask& task, const ElementSegments& segments, const SegmentsInLanes& out)
{
  HWY_DYNAMIC_DISPATCH(EncloseSegmentPacks)(task, segments, out);
}
} // namespace pixelexact
#endif
