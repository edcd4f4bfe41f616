// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/BundleKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Curved/BundleKernels.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Loads a pack of at most kLanePadding numbers. If `count` is less, the last number fills the
/// pack.
HWY_INLINE Lanes LoadSome(const double* from, int count)
{
  if (count >= LaneCount())
  {
    return NumberTraits<Lanes>::Load(from);
  }
  std::array<double, kLanePadding> some;
  some.fill(from[count - 1]);
  std::copy_n(from, count, some.begin());
  return NumberTraits<Lanes>::Load(some.data());
}

/// Calls visit(i, load, direction) for packs of `count` rays from number `first` on; load(column)
/// loads the pack that begins with ray first + i.
template <class Visit>
HWY_INLINE void ForEachPack(const RayLanes& rays, int first, int count, Visit&& visit)
{
  for (int i = 0; i < count; i += LaneCount())
  {
    const int left = std::min(count - i, LaneCount());
    const auto load = [&](const double* from) PIXELEXACT_INLINED
    { return LoadSome(from + first + i, left); };
    const Lanes direction[3] = { load(rays.direction[0]), load(rays.direction[1]),
      load(rays.direction[2]) };
    visit(i, load, direction);
  }
}

/// `axis` is the first of the axes on which the direction is longest.
HWY_INLINE LaneMask IsLongest(int axis, const Lanes (&direction)[3])
{
  const Lanes x = Abs(direction[0]);
  const Lanes y = Abs(direction[1]);
  const Lanes z = Abs(direction[2]);
  const LaneMask first = And(x >= y, x >= z);
  const LaneMask second = AndNot(y >= z, first);
  const LaneMask all = Or(x >= x, Or(y >= y, z >= z));
  return axis == 0 ? first : axis == 1 ? second : AndNot(AndNot(all, first), second);
}

/// d / d_k in pairs: one correction step of the division, from `inverse`, 1 / d_k rounded.
HWY_INLINE Pair SlopeOf(Lanes direction, Lanes along, Lanes inverse)
{
  const Lanes high = direction * inverse;
  const Pair back = ExactProduct(high, along);
  return ExactSum(high, ((direction - back.high) - back.low) * inverse);
}

struct LaneRange
{
  Lanes least;
  Lanes most;

  HWY_INLINE LaneRange()
    : least(Splat(std::numeric_limits<double>::infinity()))
    , most(Splat(-std::numeric_limits<double>::infinity()))
  {
  }
  // A NaN changes nothing.
  HWY_INLINE void Add(LaneMask mask, Lanes value)
  {
    least = Select(And(mask, value < least), value, least);
    most = Select(And(mask, most < value), value, most);
  }
  [[nodiscard]] HWY_INLINE NumberRange Found() const { return { Least(least), Most(most) }; }
};

unsigned WaysOf(const RayLanes& rays, int first, int count)
{
  unsigned ways = 0;
  const auto visit = [&](int /*i*/, const auto& load, const Lanes(&direction)[3]) PIXELEXACT_INLINED
  {
    const LaneMask isThere = load(rays.tNear) <= load(rays.tFar);
    for (int axis = 0; axis < 3; ++axis)
    {
      const LaneMask along = And(isThere, IsLongest(axis, direction));
      const Lanes one = direction[axis];
      const auto bit = static_cast<unsigned>(2 * axis);
      ways |= None(And(along, Splat(0.0) < one)) ? 0U : 1U << bit;
      ways |= None(And(along, one < Splat(0.0))) ? 0U : 2U << bit;
    }
  };
  ForEachPack(rays, first, count, visit);
  return ways;
}

void Describe(const RayLanes& rays, int first, int count, const BundleFrame& frame,
  const BundleColumns& to, BundleRanges& ranges)
{
  const auto axis = [&](std::size_t a) PIXELEXACT_INLINED
  { return static_cast<std::size_t>(frame.axes[a]); };
  const Lanes sign = Splat(frame.sign);
  LaneRange places[2];
  LaneRange slopes[2];
  LaneRange depths;
  LaneRange slacks;
  LaneRange fars;
  const auto visit = [&](int i, const auto& load, const Lanes(&direction)[3]) PIXELEXACT_INLINED
  {
    const Lanes along = direction[axis(2)];
    // A NaN is not positive.
    const LaneMask runs = And(IsLongest(frame.axes[2], direction), Splat(0.0) < sign * along);
    const Lanes from = load(rays.origin[axis(2)]);
    const Pair depth = ExactSum(from, Splat(-frame.z0));
    const Lanes inverse = Splat(1.0) / along;
    Store(along, to.direction + i);
    Store(depth.high, to.origin + i);
    Lanes size = Splat(frame.around) + Abs(from);
    Lanes place[2];
    Lanes slope[2];
    for (std::size_t a = 0; a < 2; ++a)
    {
      const Lanes origin = load(rays.origin[axis(a)]);
      const Pair exact = SlopeOf(direction[axis(a)], along, inverse);
      slope[a] = exact.high;
      // Computed in pairs, because the terms may be far larger than the place.
      place[a] = (Pair::Of(origin) - exact * depth).high;
      size = size + Abs(origin);
      Store(place[a], to.place[a] + i);
      Store(slope[a], to.slope[a] + i);
    }
    const Lanes slack = Splat(16.0 * kUnitRoundoff) * size;
    const Lanes tNear = load(rays.tNear);
    const Lanes tFar = load(rays.tFar);
    const LaneMask isThere = And(runs, And(tNear <= tFar, IsFinite(size)));
    const Lanes near = sign * (depth.high + tNear * along) - slack;
    const Lanes far = Select(isThere, sign * (depth.high + tFar * along) + slack,
      Splat(-std::numeric_limits<double>::infinity()));
    Store(slack, to.slack + i);
    Store(near, to.near + i);
    Store(far, to.far + i);
    for (std::size_t a = 0; a < 2; ++a)
    {
      places[a].Add(isThere, place[a]);
      slopes[a].Add(isThere, slope[a]);
    }
    slacks.Add(isThere, slack);
    depths.Add(isThere, near);
    depths.Add(isThere, far);
    fars.Add(isThere, far);
  };
  ForEachPack(rays, first, count, visit);
  for (std::size_t a = 0; a < 2; ++a)
  {
    ranges.place[a] = places[a].Found();
    ranges.slope[a] = slopes[a].Found();
  }
  ranges.depth = depths.Found();
  ranges.mostSlack = std::max(0.0, slacks.Found().most);
  ranges.mostFar = fars.Found().most;
}

// As RayBundle::MayMeet and DepthOf for one box.
unsigned MeetBoxes(
  const BundleRanges& ranges, const BundleFrame& frame, const EightBoxes& boxes, double* depth)
{
  const bool isUp = frame.sign > 0.0;
  const Lanes z0 = Splat(frame.z0);
  const Lanes slack = Splat(ranges.mostSlack);
  unsigned missed = 0;
  for (std::size_t i = 0; i < EightBoxes::kMax; i += static_cast<std::size_t>(LaneCount()))
  {
    const auto load = [&](const auto& columns, std::size_t a) PIXELEXACT_INLINED
    { return NumberTraits<Lanes>::Load(&columns[static_cast<std::size_t>(frame.axes[a])][i]); };
    const Lanes from = load(boxes.lower, 2) - z0;
    const Lanes to = load(boxes.upper, 2) - z0;
    const Lanes zero = Splat(0.0);
    const Lanes nearest = (isUp ? from : zero - to) - slack;
    const Lanes farthest = (isUp ? to : zero - from) + slack;
    LaneMask beside = Or(farthest < Splat(ranges.depth.least), Splat(ranges.depth.most) < nearest);
    for (std::size_t a = 0; a < 2; ++a)
    {
      const Lanes p = Splat(ranges.slope[a].least) * from;
      const Lanes q = Splat(ranges.slope[a].least) * to;
      const Lanes r = Splat(ranges.slope[a].most) * from;
      const Lanes s = Splat(ranges.slope[a].most) * to;
      const Lanes least = Splat(ranges.place[a].least) + Min(Min(p, q), Min(r, s)) - slack;
      const Lanes most = Splat(ranges.place[a].most) + Max(Max(p, q), Max(r, s)) + slack;
      beside = Or(beside, Or(load(boxes.upper, a) < least, most < load(boxes.lower, a)));
    }
    Store(nearest, depth + i);
    missed |= static_cast<unsigned>(BitsOf(beside) << i);
  }
  return ~missed & ((1U << static_cast<unsigned>(boxes.count)) - 1U);
}

const BundleKernels& BundleKernelSet()
{
  static constexpr BundleKernels kKernels{ &WaysOf, &Describe, &MeetBoxes };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(BundleKernelSet);

const BundleKernels& GetBundleKernels()
{
  return HWY_DYNAMIC_DISPATCH(BundleKernelSet)();
}
} // namespace pixelexact
#endif
