// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/PieceKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"
#include "Trace/Surfaces/Curved/PieceProof-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
RaySet MeetBox(const RayBundle& bundle, const Box3& box, const RaySet& rays)
{
  const int axis = bundle.axes[2];
  const double lower = box.lower[axis] - bundle.z0;
  const double upper = box.upper[axis] - bundle.z0;
  const Lanes nearest = Splat(std::min(bundle.sign * lower, bundle.sign * upper));
  const Lanes farthest = Splat(std::max(bundle.sign * lower, bundle.sign * upper));
  return ForEachPack(rays,
    [&](int i, LaneMask /*mask*/) PIXELEXACT_INLINED
    {
      const auto load = [&](const RayBundle::Numbers& numbers) PIXELEXACT_INLINED
      { return Traits::Load(numbers.data() + i); };
      const Lanes slack = load(bundle.slack);
      LaneMask may =
        And(farthest + slack >= load(bundle.near), nearest - slack <= load(bundle.far));
      for (std::size_t a = 0; a < 2; ++a)
      {
        const Lanes place = load(bundle.place[a]);
        const Lanes slope = load(bundle.slope[a]);
        const Lanes p = place + slope * Splat(lower);
        const Lanes q = place + slope * Splat(upper);
        may = And(may,
          And(Min(p, q) - slack <= Splat(box.upper[bundle.axes[a]]),
            Max(p, q) + slack >= Splat(box.lower[bundle.axes[a]])));
      }
      return may;
    });
}

/// One step of Newton's iteration. A step that leaves the piece, or one too many, decides nothing,
/// unless the element ends there within its tolerance; then the nearest point is searched.
void Step(const RayBundle& bundle, const ElementFrame& frame, const double* values,
  std::size_t stride, PiecePairs& pairs, double* const position[3], double* result)
{
  const auto k = static_cast<std::size_t>(bundle.axes[2]);
  const Lanes least[3] = { Splat(-1.0), Splat(-1.0), Splat(-1.0) };
  const Lanes most[3] = { Splat(1.0), Splat(1.0), Splat(1.0) };
  const auto number = [](PairResult one) { return Splat(static_cast<double>(one)); };
  for (int i = 0; i < pairs.count; i += LaneCount())
  {
    const auto load = [&](int column) PIXELEXACT_INLINED
    { return Traits::Load(pairs.Column(column) + i); };
    const auto value = [&](std::size_t n) PIXELEXACT_INLINED
    { return Traits::Load(values + n * stride + i); };
    const auto slopeAt = [&](std::size_t c, std::size_t d) PIXELEXACT_INLINED
    { return value(4 + 3 * c + d); };
    Lanes m[3][3];
    Lanes g[3];
    for (int a = 0; a < 2; ++a)
    {
      const auto c = static_cast<std::size_t>(bundle.axes[static_cast<std::size_t>(a)]);
      const Lanes s = load(kSlopeColumn + a);
      ForEachAxis([&](auto d) PIXELEXACT_INLINED { m[a][d] = slopeAt(c, d) - s * slopeAt(k, d); });
      g[a] = value(c) - s * value(k) - load(kPlaceColumn + a);
    }
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { m[2][d] = slopeAt(3, d); });
    g[2] = value(3);
    Lanes inverse[9];
    InverseOf(m, inverse);
    Lanes step[3];
    Product(inverse, g, step);
    Lanes xi[3];
    Lanes next[3];
    Lanes lower[3];
    Lanes upper[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        xi[d] = load(kXiColumn + d);
        next[d] = xi[d] - step[d];
        lower[d] = load(kLowerColumn + d);
        upper[d] = load(kUpperColumn + d);
      });
    Lanes inside[3];
    Lanes inElement[3];
    ClampTo(frame.shape, lower, upper, next, inside);
    ClampTo(frame.shape, least, most, next, inElement);
    const auto apart = [](const Lanes(&a)[3], const Lanes(&b)[3]) PIXELEXACT_INLINED
    { return Max(Abs(a[0] - b[0]), Max(Abs(a[1] - b[1]), Abs(a[2] - b[2]))); };
    const Lanes moved = Max(Abs(step[0]), Max(Abs(step[1]), Abs(step[2])));
    const Lanes beyond = apart(next, inside);
    const Lanes rounds = load(kRoundsColumn) + Splat(1.0);
    const LaneMask isFew = rounds <= Splat(kMaxRounds);
    const LaneMask isFinite = IsFinite(step[0] + step[1] + step[2]);
    const LaneMask arrived = And(moved <= Splat(kArrived), beyond <= Splat(kEdge));
    const Closeness<3> close(
      g, frame.rounding, frame.tolerance, Splat(0.0) < apart(next, inElement));
    const LaneMask isHeld = And(isFew, And(isFinite, Splat(kArrived) < apart(inside, xi)));
    const LaneMask isHit = Or(arrived, Or(close.isExact, AndNot(close.isNear, isHeld)));
    const LaneMask stays = And(isFinite, Or(beyond <= Splat(0.0), close.isNear));
    Store(rounds, pairs.Column(kRoundsColumn) + i);
    Lanes side = Splat(0.0);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const Lanes found = Select(arrived, inside[d], xi[d]);
        side = side + load(kSideColumn + d) * found;
        Store(
          Select(isHit, found, Select(stays, inside[d], xi[d])), pairs.Column(kXiColumn + d) + i);
        const auto c = static_cast<std::size_t>(d);
        const Lanes last3 =
          slopeAt(c, 0) * step[0] + slopeAt(c, 1) * step[1] + slopeAt(c, 2) * step[2];
        const Lanes y = value(c) - Select(arrived, last3, Splat(0.0));
        Store(Splat(frame.centre[d]) + Splat(frame.size) * y, position[d] + i);
      });
    const LaneMask goesOn = And(stays, isFew);
    const LaneMask isOne = And(isHit, side >= load(kMinColumn));
    Store(Select(isOne, number(PairResult::Hit),
            Select(AndNot(goesOn, isHit), number(PairResult::Again), number(PairResult::Unclear))),
      result + i);
  }
}

const PieceKernels& Table()
{
  static const PieceKernels kTable{ MeetBox, Step };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(Table);

const PieceKernels& GetPieceKernels()
{
  return HWY_DYNAMIC_DISPATCH(Table)();
}
} // namespace pixelexact
#endif
