// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/LookKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Curved/LookEnds-inl.h"
#include "Trace/Surfaces/Curved/LookKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A piece, viewed along rays of a bundle.
class PieceLook
{
public:
  HWY_INLINE PieceLook(
    const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece, OpenRays& near)
    : Frame(frame)
    , Piece(piece)
    , Near(near)
    , Across{ static_cast<std::size_t>(bundle.axes[0]), static_cast<std::size_t>(bundle.axes[1]) }
    , AlongAxis(static_cast<std::size_t>(bundle.axes[2]))
    , Along((bundle.z0 - frame.centre[bundle.axes[2]]) * frame.inverseSize)
  {
  }

  /// Tests a pack of rays. Appends those that may meet the piece, and returns those about which
  /// nothing is proven.
  HWY_INLINE LaneMask At(const GatheredRays& gathered, std::size_t i, LaneMask active)
  {
    Lanes m[3][3];
    Lanes g[3];
    Lanes rounding[3];
    Lanes bend[3];
    LookRays rays;
    rays.number = Traits::Load(&gathered.number[i]);
    rays.slack = Traits::Load(&gathered.slack[i]) * Splat(Frame.inverseSize);
    for (std::size_t a = 0; a < 2; ++a)
    {
      const std::size_t c = Across[a];
      const std::size_t k = AlongAxis;
      const Lanes s = Traits::Load(&gathered.slope[a][i]);
      const Lanes q =
        (Traits::Load(&gathered.place[a][i]) - Splat(Frame.centre[static_cast<int>(c)])) *
          Splat(Frame.inverseSize) -
        s * Splat(Along);
      ForEachAxis([&](auto d) PIXELEXACT_INLINED
        { m[a][d] = Splat(Piece.slope[c][d]) - s * Splat(Piece.slope[k][d]); });
      g[a] = Splat(Piece.value[c]) - s * Splat(Piece.value[k]) - q;
      rounding[a] = Splat(Piece.error[c]) + Abs(s) * Splat(Piece.error[k]) +
        Splat(8.0 * kUnitRoundoff) * (Abs(q) + Abs(Splat(Along))) + rays.slack;
      bend[a] = Splat(Piece.bend[c]) + Abs(s) * Splat(Piece.bend[k]);
      rays.slope[a] = s;
      rays.place[a] = q;
    }
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { m[2][d] = Splat(Piece.slope[3][d]); });
    g[2] = Splat(Piece.value[3]);
    rounding[2] = Splat(Piece.error[3]);
    bend[2] = Splat(Piece.bend[3]);
    Lanes inverse[9];
    InverseOf(m, inverse);
    Lanes first[3];
    Product(inverse, g, first);
    // NaNs neither miss nor decide.
    const Lanes zero = Splat(0.0);
    LaneMask misses = zero < zero;
    Lanes known = zero;
    RootBox roots;
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        const auto times = [&](const Lanes(&of)[3]) PIXELEXACT_INLINED
        {
          return Abs(inverse[3 * r]) * of[0] + Abs(inverse[3 * r + 1]) * of[1] +
            Abs(inverse[3 * r + 2]) * of[2];
        };
        const Lanes uncertain = times(rounding);
        known = known + uncertain;
        // A root in the piece lies in centre - first +- off, for any size of these.
        const Lanes off = (uncertain + times(bend)) * Splat(kMore) + Splat(kSlack);
        const Lanes half = Splat(Piece.half[r] * kMore);
        misses = Or(misses, half + off < Abs(first[r]));
        roots.lower[r] = Max(zero - half, zero - first[r] - off);
        roots.upper[r] = Min(half, off - first[r]);
      });
    LaneMask open = AndNot(active, misses);
    if (None(open))
    {
      return open;
    }
    const LaneMask isFinite = IsFinite(first[0] + first[1] + first[2] + known);
    if (Frame.shape != Shape::Hexahedron)
    {
      open = AndNot(open, And(isFinite, KeepToPiece(Frame.shape, Piece, roots)));
    }
    const LaneMask isNear = Piece.curves ? And(open, isFinite) : MaskOf(0);
    AppendNear(Near, isNear, rays, roots);
    return AndNot(open, isNear);
  }

private:
  const ElementFrame& Frame;
  const CurvedPiece& Piece;
  OpenRays& Near;
  std::size_t Across[2];
  std::size_t AlongAxis;
  double Along;
};

RaySet Look(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
  const RaySet& rays, OpenRays& near)
{
  near.count = 0;
  PieceLook look(bundle, frame, piece, near);
  return LookAt(bundle, rays, look);
}

const LookKernels& LookTable()
{
  static const LookKernels kTable{ Look };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(LookTable);

const LookKernels& GetLookKernels()
{
  return HWY_DYNAMIC_DISPATCH(LookTable)();
}
} // namespace pixelexact
#endif
