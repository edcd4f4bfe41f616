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
  LaneMask in = x.x[0] >= Splat(box.lower[0]);
  in = And(in, x.x[0] <= Splat(box.upper[0]));
  for (int d = 1; d < 3; ++d)
  {
    in = And(in, And(x.x[d] >= Splat(box.lower[d]), x.x[d] <= Splat(box.upper[d])));
  }
  return in;
}

PointChunk MakeChunk(const LanePoints& points, int begin, int count, const Box3& bounds)
{
  PointChunk chunk{ begin, count, 0, {} };
  const int lanes = LaneCount();
  const Lanes infinity = Splat(std::numeric_limits<double>::infinity());
  Point<Lanes> lower{ { infinity, infinity, infinity } };
  Point<Lanes> upper = lower;
  for (int d = 0; d < 3; ++d)
  {
    upper.x[d] = Splat(0.0) - infinity;
  }
  for (int i = 0; i < count; i += lanes)
  {
    const Point<Lanes> x = LoadPoint<Lanes>(points, begin + i);
    LaneMask in = InBox(x, bounds);
    if (count - i < lanes)
    {
      in = And(in, MaskOf((std::uint64_t{ 1 } << static_cast<unsigned>(count - i)) - 1U));
    }
    chunk.open |= BitsOf(in) << static_cast<unsigned>(i);
    for (int d = 0; d < 3; ++d)
    {
      lower.x[d] = Min(lower.x[d], Select(in, x.x[d], infinity));
      upper.x[d] = Max(upper.x[d], Select(in, x.x[d], Splat(0.0) - infinity));
    }
  }
  for (int d = 0; d < 3; ++d)
  {
    chunk.box.lower[d] = Least(lower.x[d]);
    chunk.box.upper[d] = Most(upper.x[d]);
  }
  return chunk;
}

std::uint64_t SelectInBox(const LanePoints& points, int begin, std::uint64_t bits, const Box3& box)
{
  const int lanes = LaneCount();
  const std::uint64_t pack = (std::uint64_t{ 1 } << static_cast<unsigned>(lanes)) - 1U;
  std::uint64_t result = 0;
  for (std::uint64_t left = bits; left != 0;)
  {
    const int i = std::countr_zero(left) / lanes * lanes;
    left &= ~(pack << static_cast<unsigned>(i));
    result |= BitsOf(InBox(LoadPoint<Lanes>(points, begin + i), box)) << static_cast<unsigned>(i);
  }
  return result & bits;
}

/// An element's frame in lanes: loaded once, for what is stored might be it as far as the compiler
/// knows.
class Frame
{
public:
  HWY_INLINE Frame(const ElementBounds& bounds, const InverseProblem& problem)
    : TheShape(problem.space.shape)
    , InverseSize(Splat(problem.inverseSize))
  {
    for (int d = 0; d < 3; ++d)
    {
      Centre.x[d] = Splat(problem.centre[d]);
      Origin.x[d] = Splat(bounds.origin[d]);
      // start - upper and start - lower at once.
      FromUpper.x[d] = Splat(problem.start[d] - bounds.upper[d]);
      FromLower.x[d] = Splat(problem.start[d] - bounds.lower[d]);
      for (int c = 0; c < 3; ++c)
      {
        Inverse.m[3 * d + c] = Splat(bounds.inverse[3 * d + c]);
      }
    }
  }

  [[nodiscard]] HWY_INLINE LaneMask Excludes(const Point<Lanes>& x) const
  {
    const Point<Lanes> y = FromOrigin(x);
    const Lanes none = Splat(0.0);
    return Beyond(Apply(Inverse, y), { { none, none, none } }, none, none);
  }

  /// A box in each lane: whether all of its points are excluded.
  [[nodiscard]] HWY_INLINE LaneMask ExcludesAll(
    const Point<Lanes>& lower, const Point<Lanes>& upper) const
  {
    const Lanes half = Splat(0.5);
    Point<Lanes> middle;
    for (int d = 0; d < 3; ++d)
    {
      middle.x[d] = half * lower.x[d] + half * upper.x[d];
    }
    const Point<Lanes> y = FromOrigin(middle);
    Point<Lanes> extent;
    for (int d = 0; d < 3; ++d)
    {
      // With the rounding of these numbers and of the products to come.
      const Lanes size = (half * upper.x[d] - half * lower.x[d]) * InverseSize;
      const Lanes terms = Abs(middle.x[d]) * InverseSize + Abs(y.x[d]) + Abs(Origin.x[d]) + size;
      extent.x[d] = MulAdd(Splat(32.0 * kUnitRoundoff), terms, size);
    }
    const auto reach = [&](Lanes a, Lanes b, Lanes c) PIXELEXACT_INLINED
    { return MulAdd(Abs(a), extent.x[0], MulAdd(Abs(b), extent.x[1], Abs(c) * extent.x[2])); };
    const auto& m = Inverse.m;
    const Point<Lanes> reaches{ { reach(m[0], m[1], m[2]), reach(m[3], m[4], m[5]),
      reach(m[6], m[7], m[8]) } };
    const Point<Lanes> offset = Apply(Inverse, y);
    switch (TheShape)
    {
      case Shape::Hexahedron:
        return Beyond(offset, reaches, half, half);
      case Shape::Tetrahedron:
        return Beyond(
          offset, reaches, reach(m[0] + m[3] + m[6], m[1] + m[4] + m[7], m[2] + m[5] + m[8]), half);
      default:
        return Beyond(offset, reaches, reach(m[0] + m[6], m[1] + m[7], m[2] + m[8]),
          reach(m[3] + m[6], m[4] + m[7], m[5] + m[8]));
    }
  }

private:
  [[nodiscard]] HWY_INLINE Point<Lanes> FromOrigin(const Point<Lanes>& x) const
  {
    Point<Lanes> y;
    for (int d = 0; d < 3; ++d)
    {
      y.x[d] = (x.x[d] - Centre.x[d]) * InverseSize - Origin.x[d];
    }
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
    for (int d = 0; d < 3; ++d)
    {
      low.x[d] = offset.x[d] + FromUpper.x[d];
      out = Or(out,
        Or(one + reach.x[d] < low.x[d], offset.x[d] + FromLower.x[d] < zero - one - reach.x[d]));
    }
    switch (TheShape)
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

  Shape TheShape;
  Lanes InverseSize;
  Point<Lanes> Centre;
  Point<Lanes> Origin;
  Matrix<Lanes> Inverse;
  Point<Lanes> FromUpper;
  Point<Lanes> FromLower;
};

std::uint64_t ChunksNear(
  const ElementBounds& bounds, const InverseProblem& problem, const BoxLanes& boxes)
{
  const Frame frame(bounds, problem);
  const LanePoints lowers{ { boxes.lower[0], boxes.lower[1], boxes.lower[2] }, boxes.count };
  const LanePoints uppers{ { boxes.upper[0], boxes.upper[1], boxes.upper[2] }, boxes.count };
  std::uint64_t near = 0;
  for (int i = 0; i < boxes.count; i += LaneCount())
  {
    const auto lower = LoadPoint<Lanes>(lowers, i);
    const auto upper = LoadPoint<Lanes>(uppers, i);
    LaneMask meets = lower.x[0] <= upper.x[0];
    for (int d = 0; d < 3; ++d)
    {
      meets = And(meets,
        And(lower.x[d] <= Splat(bounds.box.upper[d]), Splat(bounds.box.lower[d]) <= upper.x[d]));
    }
    if (None(meets))
    {
      continue;
    }
    if (bounds.framed)
    {
      meets = AndNot(meets, frame.ExcludesAll(lower, upper));
    }
    near |= BitsOf(meets) << static_cast<unsigned>(i);
  }
  return near;
}

std::uint64_t Select(const ElementBounds& bounds, const InverseProblem& problem,
  const LanePoints& points, const PointChunk& chunk, double* const selected[3], int* index)
{
  const int lanes = LaneCount();
  const std::uint64_t pack = (std::uint64_t{ 1 } << static_cast<unsigned>(lanes)) - 1U;
  const Frame frame(bounds, problem);
  double* const to[3] = { selected[0], selected[1], selected[2] };
  std::uint64_t result = 0;
  std::ptrdiff_t count = 0;
  for (std::uint64_t left = chunk.open; left != 0;)
  {
    const int i = std::countr_zero(left) / lanes * lanes;
    LaneMask in = MaskOf((left >> static_cast<unsigned>(i)) & pack);
    left &= ~(pack << static_cast<unsigned>(i));
    const Point<Lanes> x = LoadPoint<Lanes>(points, chunk.begin + i);
    in = And(in, InBox(x, bounds.box));
    if (None(in))
    {
      continue;
    }
    if (bounds.framed)
    {
      in = AndNot(in, frame.Excludes(x));
    }
    const std::uint64_t kept = BitsOf(in);
    // Packing costs more than the test: mostly all or none of a pack are kept.
    if (kept == pack)
    {
      for (int d = 0; d < 3; ++d)
      {
        Store(x.x[d], to[d] + count);
      }
      for (int k = 0; k < lanes; ++k)
      {
        index[count + k] = chunk.begin + i + k;
      }
      count += lanes;
    }
    else if (kept != 0)
    {
      for (int d = 0; d < 3; ++d)
      {
        StorePacked(x.x[d], in, to[d] + count);
      }
      for (std::uint64_t bits = kept; bits != 0; bits &= bits - 1)
      {
        index[count++] = chunk.begin + i + std::countr_zero(bits);
      }
    }
    result |= kept << static_cast<unsigned>(i);
  }
  return result;
}

/// A bit for each lane of a pack at i whose root is inside, of those before `count`.
HWY_INLINE LaneMask InsideAt(const double* status, int i, int count)
{
  const Lanes wanted = Splat(static_cast<double>(NewtonStatus::RootInside));
  const Lanes at = NumberTraits<Lanes>::Load(status + i);
  const LaneMask in = And(at <= wanted, at >= wanted);
  return count - i < LaneCount()
    ? And(in, MaskOf((std::uint64_t{ 1 } << static_cast<unsigned>(count - i)) - 1U))
    : in;
}

int FindOthers(const double* status, int count, int* others)
{
  const int lanes = LaneCount();
  int found = 0;
  for (int i = 0; i < count; i += lanes)
  {
    const LaneMask in = InsideAt(status, i, count);
    if (All(in))
    {
      continue;
    }
    const std::uint64_t bits = BitsOf(in);
    for (int k = 0; k < std::min(lanes, count - i); ++k)
    {
      if ((bits >> static_cast<unsigned>(k) & 1U) == 0)
      {
        others[found++] = i + k;
      }
    }
  }
  return found;
}

void KeepInside(const InverseResult& result, int count, int* index)
{
  const int lanes = LaneCount();
  int kept = 0;
  for (int i = 0; i < count; i += lanes)
  {
    const LaneMask in = InsideAt(result.status, i, count);
    const std::uint64_t bits = BitsOf(in);
    if (std::popcount(bits) == lanes && kept == i)
    {
      kept += lanes;
      continue;
    }
    // What is stored never runs ahead of what is loaded.
    for (double* array : { result.xi[0], result.xi[1], result.xi[2], result.residual })
    {
      StorePacked(NumberTraits<Lanes>::Load(array + i), in, array + kept);
    }
    for (std::uint64_t left = bits; left != 0; left &= left - 1)
    {
      index[kept++] = index[i + std::countr_zero(left)];
    }
  }
  for (int k = kept; kept > 0 && k < PaddedCount(kept); ++k)
  {
    for (double* array : { result.xi[0], result.xi[1], result.xi[2], result.residual })
    {
      array[k] = array[kept - 1];
    }
  }
}

const PointKernels& PointKernelSet()
{
  static constexpr PointKernels kKernels{ &MakeChunk, &SelectInBox, &ChunksNear, &Select,
    &FindOthers, &KeepInside };
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
