// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Location/PointKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Location/PointKernels.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
HWY_INLINE Point<Lanes> LoadAt(const LanePoints& points, int at)
{
  using Traits = NumberTraits<Lanes>;
  return { { Traits::Load(points.x[0] + at), Traits::Load(points.x[1] + at),
    Traits::Load(points.x[2] + at) } };
}

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
    const Point<Lanes> x = LoadAt(points, begin + i);
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
    result |= BitsOf(InBox(LoadAt(points, begin + i), box)) << static_cast<unsigned>(i);
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

  /// Written so that a NaN excludes nothing.
  [[nodiscard]] HWY_INLINE LaneMask Excludes(const Point<Lanes>& x) const
  {
    Point<Lanes> y;
    for (int d = 0; d < 3; ++d)
    {
      y.x[d] = (x.x[d] - Centre.x[d]) * InverseSize - Origin.x[d];
    }
    const Lanes one = Splat(1.0);
    const Lanes zero = Splat(0.0);
    const Point<Lanes> offset = Apply(Inverse, y);
    Point<Lanes> low;
    LaneMask out = zero < zero;
    for (int d = 0; d < 3; ++d)
    {
      low.x[d] = offset.x[d] + FromUpper.x[d];
      out = Or(out, Or(one < low.x[d], offset.x[d] + FromLower.x[d] < zero - one));
    }
    switch (TheShape)
    {
      case Shape::Hexahedron:
        return out;
      case Shape::Prism:
        return Or(out, zero < low.x[0] + low.x[2]);
      case Shape::Tetrahedron:
        return Or(out, zero - one < low.x[0] + low.x[1] + low.x[2]);
      default:
        return Or(out, Or(zero < low.x[0] + low.x[2], zero < low.x[1] + low.x[2]));
    }
  }

private:
  Shape TheShape;
  Lanes InverseSize;
  Point<Lanes> Centre;
  Point<Lanes> Origin;
  Matrix<Lanes> Inverse;
  Point<Lanes> FromUpper;
  Point<Lanes> FromLower;
};

std::uint64_t SelectByFrame(const ElementBounds& bounds, const InverseProblem& problem,
  const LanePoints& points, int begin, std::uint64_t bits, double* const selected[3])
{
  const int lanes = LaneCount();
  const std::uint64_t pack = (std::uint64_t{ 1 } << static_cast<unsigned>(lanes)) - 1U;
  const Frame frame(bounds, problem);
  const bool framed = bounds.framed;
  double* const to[3] = { selected[0], selected[1], selected[2] };
  std::uint64_t result = 0;
  std::ptrdiff_t count = 0;
  for (std::uint64_t left = bits; left != 0;)
  {
    const int i = std::countr_zero(left) / lanes * lanes;
    LaneMask in = MaskOf((left >> static_cast<unsigned>(i)) & pack);
    left &= ~(pack << static_cast<unsigned>(i));
    const Point<Lanes> x = LoadAt(points, begin + i);
    if (framed)
    {
      in = AndNot(in, frame.Excludes(x));
    }
    const std::uint64_t kept = BitsOf(in);
    // Packing costs more than the test: mostly all or none of a pack are kept.
    for (int d = 0; d < 3 && kept != 0; ++d)
    {
      if (kept == pack)
      {
        Store(x.x[d], to[d] + count);
      }
      else
      {
        StorePacked(x.x[d], in, to[d] + count);
      }
    }
    count += std::popcount(kept);
    result |= kept << static_cast<unsigned>(i);
  }
  return result;
}

void KeepInside(const InverseResult& result, int count)
{
  const int lanes = LaneCount();
  int kept = 0;
  for (int i = 0; i < count; i += lanes)
  {
    const Lanes status = NumberTraits<Lanes>::Load(result.status + i);
    const Lanes wanted = Splat(static_cast<double>(NewtonStatus::RootInside));
    LaneMask in = And(status <= wanted, status >= wanted);
    if (count - i < lanes)
    {
      in = And(in, MaskOf((std::uint64_t{ 1 } << static_cast<unsigned>(count - i)) - 1U));
    }
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
    kept += std::popcount(bits);
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
  static constexpr PointKernels kKernels{ &MakeChunk, &SelectInBox, &SelectByFrame, &KeepInside };
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
