// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Core/Tree/TreeKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Math/Rounding.h"
#include "Core/Tree/Regularity.h"
#include "Core/Tree/TreeKernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
HWY_INLINE Point<Lanes> LoadGroup(const GroupLanes& group, int at)
{
  return LoadPoint<Lanes>({ { group.x[0], group.x[1], group.x[2] }, kGroupPoints }, at);
}

/// 2 s_d: twice the extent of the shape that eta_d is relative to.
HWY_INLINE Lanes TwiceExtent(Shape shape, int direction, const Point<Lanes>& xi)
{
  if (shape == Shape::Tetrahedron && direction == 0)
  {
    return Splat(0.0) - (xi.x[1] + xi.x[2]);
  }
  const bool collapses = direction == 0
    ? shape != Shape::Hexahedron
    : direction == 1 && (shape == Shape::Tetrahedron || shape == Shape::Pyramid);
  return collapses ? Splat(1.0) - xi.x[2] : Splat(2.0);
}

/// 1 + xi_d - (1 + b) s_d: positive beyond the end eta_d = b.
HWY_INLINE Lanes Beyond(double end, const Lanes& xi, const Lanes& twiceExtent)
{
  return NegMulAdd(Splat(0.5 * (1.0 + end)), twiceExtent, Splat(1.0) + xi);
}

template <bool kWide>
NodeClassification ClassifyPoints(
  const NodeFrame& frame, const double* const y[3], std::uint64_t bits)
{
  const LanePoints points{ { y[0], y[1], y[2] }, kGroupPoints };
  NodeClassification classification;
  classification.near = ForEachPackIn(bits,
    [&](int i) PIXELEXACT_INLINED
    {
      const auto at = LoadPoint<Lanes>(points, i);
      LaneMask in = Abs(at.x[0]) >= Splat(0.0);
      for (std::size_t c = 0; c < 3; ++c)
      {
        in = And(
          in, And(at.x[c] >= Splat(frame.hull[c].lower), at.x[c] <= Splat(frame.hull[c].upper)));
      }
      if (!frame.framed || None(in))
      {
        return in;
      }
      Point<Lanes> from;
      for (std::size_t c = 0; c < 3; ++c)
      {
        from.x[c] = at.x[c] - Splat(frame.origin[c]);
      }
      LaneMask out = at.x[0] < at.x[0];
      LaneMask beside = out;
      for (const ImagePlane& plane : frame.plane)
      {
        const auto& n = plane.normal;
        const Lanes along =
          MulAdd(Splat(n[0]), from.x[0], MulAdd(Splat(n[1]), from.x[1], Splat(n[2]) * from.x[2]));
        out = Or(out, Splat(kWide ? plane.wider : plane.outer) < along);
        beside = Or(beside, Splat(plane.inner) < along);
      }
      classification.held |= BitsOf(AndNot(in, beside)) << static_cast<unsigned>(i);
      return AndNot(in, out);
    });
  classification.held &= classification.near;
  return classification;
}

NodeClassification Classify(const NodeFrame& frame, const double* const y[3], std::uint64_t bits)
{
  return ClassifyPoints<false>(frame, y, bits);
}

NodeClassification ClassifyWidely(
  const NodeFrame& frame, const double* const y[3], std::uint64_t bits)
{
  return ClassifyPoints<true>(frame, y, bits);
}

NodeClassification ClassifyBoxesWidely(
  const NodeFrame& frame, const BoxesOfGroups& boxes, std::uint64_t bits)
{
  NodeClassification classification;
  classification.near = ForEachPackIn(bits,
    [&](int i) PIXELEXACT_INLINED
    {
      const Point<Lanes> middle = LoadGroup(boxes.middle, i);
      const Point<Lanes> reach = LoadGroup(boxes.reach, i);
      LaneMask near = reach.x[0] >= Splat(0.0);
      LaneMask held = near;
      for (std::size_t c = 0; c < 3; ++c)
      {
        // The rounding of the two sums; ends of the hull are rounded much more.
        const Lanes rounding = Splat(4.0 * kUnitRoundoff) * (Abs(middle.x[c]) + reach.x[c]);
        const Lanes lower = middle.x[c] - reach.x[c] - rounding;
        const Lanes upper = middle.x[c] + reach.x[c] + rounding;
        const Lanes hullLower = Splat(frame.hull[c].lower);
        const Lanes hullUpper = Splat(frame.hull[c].upper);
        near = And(near, And(lower <= hullUpper, upper >= hullLower));
        held = And(held, And(lower >= hullLower, upper <= hullUpper));
      }
      LaneMask whole = held;
      if (!frame.framed)
      {
        classification.whole |= BitsOf(And(near, whole)) << static_cast<unsigned>(i);
        return near;
      }
      if (!None(near))
      {
        LaneMask beside = AndNot(near, near);
        Point<Lanes> from;
        Point<Lanes> error;
        for (std::size_t c = 0; c < 3; ++c)
        {
          from.x[c] = middle.x[c] - Splat(frame.origin[c]);
          error.x[c] = Splat(16.0 * kUnitRoundoff) *
            (Abs(middle.x[c]) + reach.x[c] + Splat(std::fabs(frame.origin[c])));
        }
        for (const ImagePlane& plane : frame.plane)
        {
          Lanes along = Splat(0.0);
          Lanes across = Splat(0.0);
          for (std::size_t c = 0; c < 3; ++c)
          {
            along = MulAdd(Splat(plane.normal[c]), from.x[c], along);
            across = MulAdd(Splat(std::fabs(plane.normal[c])), reach.x[c] + error.x[c], across);
          }
          near = AndNot(near, Splat(plane.wider) < along - across);
          held = And(held, along + across <= Splat(plane.inner));
          whole = And(whole, along + across <= Splat(plane.wider));
          beside = Or(beside, Splat(plane.inner) < along - across);
        }
        whole = And(whole, beside);
      }
      classification.held |= BitsOf(And(near, held)) << static_cast<unsigned>(i);
      classification.whole |= BitsOf(And(near, whole)) << static_cast<unsigned>(i);
      return near;
    });
  classification.held &= classification.near;
  classification.whole &= classification.near;
  return classification;
}

void Scale(const LanePoints& x, int begin, int count, const double* centre, double inverseSize,
  double* const y[3])
{
  for (int i = 0; i < count; i += LaneCount())
  {
    const auto at = LoadPoint<Lanes>(x, begin + i);
    for (int d = 0; d < 3; ++d)
    {
      Store((at.x[d] - Splat(centre[d])) * Splat(inverseSize), y[d] + i);
    }
  }
}

std::uint64_t Reached(
  const EtaBox& box, Shape shape, double reach, const GroupRoots& roots, std::uint64_t bits)
{
  double lower[3];
  double upper[3];
  for (int d = 0; d < 3; ++d)
  {
    const double margin = reach * (box.upper[d] - box.lower[d]);
    lower[d] = box.lower[d] - margin;
    upper[d] = CollapsesAt(shape, d) ? std::min(1.0, box.upper[d] + margin) : box.upper[d] + margin;
  }
  return ForEachPackIn(bits,
    [&](int i) PIXELEXACT_INLINED
    {
      const Point<Lanes> xi = LoadGroup(roots.xi, i);
      const Lanes tolerance = NumberTraits<Lanes>::Load(roots.tolerance + i);
      LaneMask in = Abs(tolerance) >= Splat(0.0);
      for (int d = 0; d < 3; ++d)
      {
        const Lanes extent = TwiceExtent(shape, d, xi);
        in = And(in,
          And(Beyond(upper[d], xi.x[d], extent) <= tolerance,
            Beyond(lower[d], xi.x[d], extent) >= Splat(0.0) - tolerance));
      }
      return in;
    });
}

const TreeKernels& TreeKernelSet()
{
  static constexpr TreeKernels kKernels{ &Classify, &ClassifyWidely, &ClassifyBoxesWidely, &Reached,
    &Scale };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(TreeKernelSet);

const TreeKernels& GetTreeKernels()
{
  return HWY_DYNAMIC_DISPATCH(TreeKernelSet)();
}
} // namespace pixelexact
#endif
