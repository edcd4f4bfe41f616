// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Location/InnerPointKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Guess-inl.h"
#include "Core/Location/PointKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Whether the guess is inside the shape, at least `depth` from its faces.
HWY_INLINE LaneMask IsDeep(const InverseProblem& problem, double depth, const Point<Lanes>& y)
{
  Matrix<Lanes> frame;
  ForEachUpTo(
    Const<8>(), [&](auto k) PIXELEXACT_INLINED { frame.m[k] = Splat(problem.inverse[k]); });
  Point<Lanes> fromOrigin;
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED { fromOrigin.x[d] = y.x[d] - Splat(problem.origin[d]); });
  Point<Lanes> start = Apply(frame, fromOrigin);
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED { start.x[d] = start.x[d] + Splat(problem.start[d]); });
  const Lanes zero = Splat(0.0);
  return WidenedMargin(problem.space.shape, Guess(problem, start),
           Point<Lanes>{ { zero, zero, zero } }) >= Splat(depth);
}

std::uint64_t FindDeep(
  const InverseProblem& problem, double depth, const LanePoints& y, std::uint64_t bits)
{
  return ForEachPackIn(
    bits, [&](int i) PIXELEXACT_INLINED { return IsDeep(problem, depth, LoadPoint<Lanes>(y, i)); });
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(FindDeep);

std::uint64_t FindInnerPoints(const ElementBounds& bounds, const InverseProblem& problem,
  const LanePoints& y, std::uint64_t bits)
{
  constexpr double kPoor = 0.25;
  // The fraction of the guess's largest error that a point must be inside; larger errors are rare.
  constexpr double kPart = 0.25;
  if (bits == 0 || !(bounds.guess.error <= kPoor))
  {
    return 0;
  }
  return HWY_DYNAMIC_DISPATCH(FindDeep)(problem, kPart * bounds.guess.error, y, bits);
}
} // namespace pixelexact
#endif
