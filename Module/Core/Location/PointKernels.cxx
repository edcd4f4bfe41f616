// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Location/PointKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Location/PointKernels.h"
#include "Core/Math/Rounding.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A NaN is in no box.
HWY_INLINE LaneMask InBox(const Point<Lanes>& x, const Box3& box)
{
  LaneMask in = And(x.x[0] >= Splat(box.lower[0]), x.x[0] <= Splat(box.upper[0]));
  in = And(in, And(x.x[1] >= Splat(box.lower[1]), x.x[1] <= Splat(box.upper[1])));
  return And(in, And(x.x[2] >= Splat(box.lower[2]), x.x[2] <= Splat(box.upper[2])));
}

PointChunk MakeChunk(const LanePoints& points, int begin, int count, const Box3& bounds)
{
  PointChunk chunk{ begin, count, 0, {} };
  const LanePoints from = points; // that no store can change
  const Box3 within = bounds;
  const int lanes = LaneCount();
  const Lanes infinity = Splat(std::numeric_limits<double>::infinity());
  const Lanes minusInfinity = Splat(-std::numeric_limits<double>::infinity());
  Point<Lanes> lower{ { infinity, infinity, infinity } };
  Point<Lanes> upper{ { minusInfinity, minusInfinity, minusInfinity } };
  std::uint64_t open = 0;
  for (int i = 0; i < count; i += lanes)
  {
    const auto x = LoadPoint<Lanes>(from, begin + i);
    LaneMask in = InBox(x, within);
    if (count - i < lanes)
    {
      in = And(in, MaskOf((std::uint64_t{ 1 } << static_cast<unsigned>(count - i)) - 1U));
    }
    open |= BitsOf(in) << static_cast<unsigned>(i);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        lower.x[d] = Min(lower.x[d], Select(in, x.x[d], infinity));
        upper.x[d] = Max(upper.x[d], Select(in, x.x[d], minusInfinity));
      });
  }
  chunk.open = open;
  for (int d = 0; d < 3; ++d)
  {
    chunk.box.lower[d] = Least(lower.x[d]);
    chunk.box.upper[d] = Most(upper.x[d]);
  }
  return chunk;
}

std::uint64_t SelectInBox(const LanePoints& points, int begin, std::uint64_t bits, const Box3& box)
{
  return ForEachPackIn(bits,
    [&](int i) PIXELEXACT_INLINED { return InBox(LoadPoint<Lanes>(points, begin + i), box); });
}

/// An element's frame in lanes. It is loaded once into local variables, because the compiler must
/// assume that a store could change the original.
class ElementFrame
{
public:
  HWY_INLINE ElementFrame(const ElementBounds& bounds, const InverseProblem& problem)
    : shape_(problem.space.shape)
    , InverseSize(Splat(problem.inverseSize))
  {
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        Centre.x[d] = Splat(problem.centre[d]);
        Origin.x[d] = Splat(bounds.origin[d]);
        // start - upper and start - lower at once.
        FromUpper.x[d] = Splat(problem.start[d] - bounds.upper[d]);
        FromLower.x[d] = Splat(problem.start[d] - bounds.lower[d]);
      });
    ForEachUpTo(
      Const<8>(), [&](auto k) PIXELEXACT_INLINED { Inverse.m[k] = Splat(bounds.inverse[k]); });
  }

  [[nodiscard]] HWY_INLINE LaneMask Excludes(const Point<Lanes>& x) const
  {
    const Point<Lanes> y = FromOrigin(x);
    const Lanes none = Splat(0.0);
    return Beyond(Apply(Inverse, y), { { none, none, none } }, none, none);
  }

  /// Whether the test above excludes all points of the box in each lane, and whether it excludes
  /// none.
  struct Classification
  {
    LaneMask none;
    LaneMask all;
  };
  [[nodiscard]] HWY_INLINE Classification Classify(
    const Point<Lanes>& lower, const Point<Lanes>& upper) const
  {
    const Lanes half = Splat(0.5);
    const Lanes zero = Splat(0.0);
    Point<Lanes> middle;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED { middle.x[d] = half * lower.x[d] + half * upper.x[d]; });
    const Point<Lanes> y = FromOrigin(middle);
    Point<Lanes> extent;
    Point<Lanes> rounding; // of these numbers and of the products to come
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        extent.x[d] = (half * upper.x[d] - half * lower.x[d]) * InverseSize;
        rounding.x[d] = Splat(32.0 * kUnitRoundoff) *
          (Abs(middle.x[d]) * InverseSize + Abs(y.x[d]) + Abs(Origin.x[d]) + extent.x[d]);
      });
    const auto across = [](Lanes a, Lanes b, Lanes c, const Point<Lanes>& of) PIXELEXACT_INLINED
    { return MulAdd(Abs(a), of.x[0], MulAdd(Abs(b), of.x[1], Abs(c) * of.x[2])); };
    const auto& m = Inverse.m;
    Point<Lanes> reach;
    Point<Lanes> error;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        error.x[d] = across(m[3 * d], m[3 * d + 1], m[3 * d + 2], rounding);
        reach.x[d] = across(m[3 * d], m[3 * d + 1], m[3 * d + 2], extent) + error.x[d];
      });
    // The sums of rows along the slanted faces' normals: rows may cancel, their errors do not.
    Lanes first = zero;
    Lanes second = zero;
    if (shape_ == Shape::Tetrahedron)
    {
      first = across(m[0] + m[3] + m[6], m[1] + m[4] + m[7], m[2] + m[5] + m[8], extent) +
        (error.x[0] + error.x[1] + error.x[2]);
    }
    else if (shape_ != Shape::Hexahedron)
    {
      first = across(m[0] + m[6], m[1] + m[7], m[2] + m[8], extent) + (error.x[0] + error.x[2]);
      second = across(m[3] + m[6], m[4] + m[7], m[5] + m[8], extent) + (error.x[1] + error.x[2]);
    }
    const Point<Lanes> offset = Apply(Inverse, y);
    const LaneMask none = Beyond(offset, reach, first, second);
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { reach.x[d] = zero - reach.x[d]; });
    const LaneMask some = Beyond(offset, reach, zero - first, zero - second);
    return { none, AndNot(zero <= zero, some) };
  }

private:
  [[nodiscard]] HWY_INLINE Point<Lanes> FromOrigin(const Point<Lanes>& x) const
  {
    Point<Lanes> y;
    ForEachAxis([&](auto d) PIXELEXACT_INLINED
      { y.x[d] = (x.x[d] - Centre.x[d]) * InverseSize - Origin.x[d]; });
    return y;
  }

  /// Whether what lies within `reach` of an offset from the shape's centre is beyond a face:
  /// `first` and `second` are the reaches along the slanted faces' normals. A NaN is not.
  [[nodiscard]] HWY_INLINE LaneMask Beyond(
    const Point<Lanes>& offset, const Point<Lanes>& reach, Lanes first, Lanes second) const
  {
    const Lanes one = Splat(1.0);
    const Lanes zero = Splat(0.0);
    Point<Lanes> low;
    LaneMask out = zero < zero;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        low.x[d] = offset.x[d] + FromUpper.x[d];
        out = Or(out,
          Or(one + reach.x[d] < low.x[d], offset.x[d] + FromLower.x[d] < zero - one - reach.x[d]));
      });
    switch (shape_)
    {
      case Shape::Hexahedron:
        return out;
      case Shape::Prism:
        return Or(out, first < low.x[0] + low.x[2]);
      case Shape::Tetrahedron:
        return Or(out, first - one < low.x[0] + low.x[1] + low.x[2]);
      default:
        return Or(out, Or(first < low.x[0] + low.x[2], second < low.x[1] + low.x[2]));
    }
  }

  Shape shape_;
  Lanes InverseSize;
  Point<Lanes> Centre;
  Point<Lanes> Origin;
  Matrix<Lanes> Inverse;
  Point<Lanes> FromUpper;
  Point<Lanes> FromLower;
};

NearChunks FindNearChunks(
  const ElementBounds& bounds, const InverseProblem& problem, const BoxLanes& boxes)
{
  const ElementFrame frame(bounds, problem);
  const LanePoints lowers{ { boxes.lower[0], boxes.lower[1], boxes.lower[2] }, boxes.count };
  const LanePoints uppers{ { boxes.upper[0], boxes.upper[1], boxes.upper[2] }, boxes.count };
  NearChunks found;
  for (int i = 0; i < boxes.count; i += LaneCount())
  {
    const auto lower = LoadPoint<Lanes>(lowers, i);
    const auto upper = LoadPoint<Lanes>(uppers, i);
    LaneMask near = lower.x[0] <= upper.x[0];
    LaneMask within = near;
    for (int d = 0; d < 3; ++d)
    {
      const Lanes boxLower = Splat(bounds.box.lower[d]);
      const Lanes boxUpper = Splat(bounds.box.upper[d]);
      near = And(near, And(lower.x[d] <= boxUpper, boxLower <= upper.x[d]));
      within = And(within, And(boxLower <= lower.x[d], upper.x[d] <= boxUpper));
    }
    if (None(near))
    {
      continue;
    }
    if (bounds.framed)
    {
      const auto [none, all] = frame.Classify(lower, upper);
      near = AndNot(near, none);
      found.inner |= BitsOf(And(And(near, within), all)) << static_cast<unsigned>(i);
    }
    found.near |= BitsOf(near) << static_cast<unsigned>(i);
  }
  return found;
}

std::uint64_t Select(const ElementBounds& bounds, const InverseProblem& problem,
  const LanePoints& points, const PointChunk& chunk, bool inner, double* const selected[3],
  int* index)
{
  const int lanes = LaneCount();
  const std::uint64_t pack = (std::uint64_t{ 1 } << static_cast<unsigned>(lanes)) - 1U;
  const ElementFrame frame(bounds, problem);
  // Copies that no store can change.
  double* const to[3] = { selected[0], selected[1], selected[2] };
  const LanePoints from = points;
  const Box3 box = bounds.box;
  const bool framed = bounds.framed;
  const int begin = chunk.begin;
  std::uint64_t result = 0;
  std::ptrdiff_t count = 0;
  for (std::uint64_t left = chunk.open; left != 0;)
  {
    const int i = std::countr_zero(left) / lanes * lanes;
    LaneMask in = MaskOf((left >> static_cast<unsigned>(i)) & pack);
    left &= ~(pack << static_cast<unsigned>(i));
    const auto x = LoadPoint<Lanes>(from, begin + i);
    if (!inner)
    {
      in = And(in, InBox(x, box));
      if (None(in))
      {
        continue;
      }
      if (framed)
      {
        in = AndNot(in, frame.Excludes(x));
      }
    }
    const std::uint64_t kept = BitsOf(in);
    // Most packs are kept as a whole or not at all.
    if (kept == pack)
    {
      ForEachAxis([&](auto d) PIXELEXACT_INLINED { Store(x.x[d], to[d] + count); });
      StoreNumbers(begin + i, index + count);
      count += lanes;
    }
    else if (kept != 0)
    {
      const LanesToFront front(kept);
      ForEachAxis([&](auto d) PIXELEXACT_INLINED { Store(front(x.x[d]), to[d] + count); });
      front.StoreNumbers(begin + i, index + count);
      count += std::popcount(kept);
    }
    result |= kept << static_cast<unsigned>(i);
  }
  return result;
}

const PointKernels& PointKernelSet()
{
  static constexpr PointKernels kKernels{ &MakeChunk, &SelectInBox, &FindNearChunks, &Select };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(PointKernelSet);

const PointKernels& GetPointKernels()
{
  return HWY_DYNAMIC_DISPATCH(PointKernelSet)();
}
} // namespace pixelexact
#endif
