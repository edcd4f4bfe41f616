// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/AlongRayKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Curved/LookEnds-inl.h"
#include "Trace/Surfaces/Curved/LookKernels.h"
#include "Trace/Surfaces/Curved/RayQuadratic-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A piece's f along rays.
class PieceAlongRays
{
public:
  HWY_INLINE PieceAlongRays(const RayBundle& bundle, const ElementFrame& frame,
    const CurvedPiece& piece, OpenRays& near, OpenRays& open, PiecePairs& pairs)
    : Frame(frame)
    , Piece(piece)
    , Near(near)
    , Open(open)
    , Pairs(pairs)
    , Across{ static_cast<std::size_t>(bundle.axes[0]), static_cast<std::size_t>(bundle.axes[1]) }
    , AlongAxis(static_cast<std::size_t>(bundle.axes[2]))
    , Along((bundle.z0 - frame.centre[bundle.axes[2]]) * frame.inverseSize)
    , Curves(piece)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        Slope[c][d] = piece.slope[c][d] + Curves.shift[c][d];
      }
    }
  }

  /// Tests the pack of near rays from i on, in the lanes `active`. Returns those that stay unclear.
  HWY_INLINE LaneMask At(int i, LaneMask active)
  {
    const LookRays rays = LoadRays(Near, i);
    RootBox roots;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        roots.lower[d] = Traits::Load(Near.Column(kOpenLowerColumn + d) + i);
        roots.upper[d] = Traits::Load(Near.Column(kOpenUpperColumn + d) + i);
      });
    const RayQuadratic f(PointOf(rays), roots);
    RayStretch stretch[2];
    f.Split(stretch[0], stretch[1]);
    RootBox box[2];
    LaneMask unclear = AndNot(active, f.isValid);
    for (int k = 0; k < 2; ++k)
    {
      box[k] = roots;
      LaneMask empty = f.Keep(stretch[k], box[k]);
      if (Frame.shape != Shape::Hexahedron)
      {
        empty = Or(empty, KeepToPiece(Frame.shape, Piece, box[k]));
      }
      stretch[k].isThere = And(active, AndNot(stretch[k].isThere, empty));
      unclear = Or(unclear, AndNot(stretch[k].isThere, stretch[k].isUnique));
    }
    for (int k = 0; k < 2; ++k)
    {
      const LaneMask some = AndNot(stretch[k].isThere, unclear);
      if (!None(some))
      {
        LookFor(rays, f, stretch[k], box[k], k == 0 ? -1.0 : 1.0, some);
      }
    }
    return unclear;
  }

private:
  [[nodiscard]] HWY_INLINE RayPoint PointOf(const LookRays& rays) const
  {
    RayPoint at;
    const auto& k = AlongAxis;
    for (std::size_t a = 0; a < 2; ++a)
    {
      const std::size_t c = Across[a];
      const Lanes s = rays.slope[a];
      const Lanes q = rays.place[a];
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED
        {
          at.m[a][d] = Splat(Slope[c][d]) - s * Splat(Slope[k][d]);
          at.rest[a][d] = Splat(Curves.rest[c][d]) + Abs(s) * Splat(Curves.rest[k][d]);
        });
      for (std::size_t n = 0; n < 6; ++n)
      {
        at.curve[a].m[n] = Splat(Curves.curve[c][n]) - s * Splat(Curves.curve[k][n]);
      }
      at.g[a] = Splat(Piece.value[c]) - s * Splat(Piece.value[k]) - q;
      at.rounding[a] = Splat(Piece.error[c]) + Abs(s) * Splat(Piece.error[k]) +
        Splat(8.0 * kUnitRoundoff) * (Abs(q) + Abs(Splat(Along))) + rays.slack;
    }
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        at.m[2][d] = Splat(Slope[3][d]);
        at.rest[2][d] = Splat(Curves.rest[3][d]);
      });
    for (std::size_t n = 0; n < 6; ++n)
    {
      at.curve[2].m[n] = Splat(Curves.curve[3][n]);
    }
    at.g[2] = Splat(Piece.value[3]);
    at.rounding[2] = Splat(Piece.error[3]);
    return at;
  }

  /// Searches the only root of a stretch. If it is expected in the piece, it becomes a pair that
  /// must not end beyond the parabola's vertex; otherwise it becomes an open ray for a closer look.
  HWY_INLINE void LookFor(const LookRays& rays, const RayQuadratic& f, const RayStretch& stretch,
    const RootBox& box, double sense, LaneMask some)
  {
    Lanes expected[3];
    RootSide side;
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const Lanes off = f.centre[d] + stretch.root * f.e[d];
        expected[d] = Splat(Piece.centre[d]) + Max(Min(off, box.upper[d]), box.lower[d]);
        side.normal[d] = Splat(sense) * f.e[d];
      });
    // Roots of this side lie beyond the end of the stretch that is nearer to the vertex.
    const Lanes end = sense < 0.0 ? stretch.to : stretch.from;
    const Lanes centre[3] = { Splat(Piece.centre[0]), Splat(Piece.centre[1]),
      Splat(Piece.centre[2]) };
    side.least = Splat(sense) * (Dot(f.e, centre) + end) - Splat(kSlack);
    const RootStart start = StartOf(Frame.shape, Piece, expected);
    const LaneMask pair = And(some, start.isInside);
    AppendPairs(Pairs, pair, rays, Piece, start, side);
    AppendOpen(Open, AndNot(some, pair), rays, box, start, side);
  }

  const ElementFrame& Frame;
  const CurvedPiece& Piece;
  OpenRays& Near;
  OpenRays& Open;
  PiecePairs& Pairs;
  std::size_t Across[2];
  std::size_t AlongAxis;
  double Along;
  Curvature Curves;
  double Slope[4][3]; ///< the slopes around which their ranges are smallest
};

RaySet LookAlong(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
  OpenRays& near, OpenRays& open, PiecePairs& pairs)
{
  open.count = 0;
  PieceAlongRays look(bundle, frame, piece, near, open, pairs);
  return LookAtOpen(near, near.count, piece, pairs,
    [&](int i, LaneMask active) PIXELEXACT_INLINED { return look.At(i, active); });
}

const AlongRayKernels& AlongRayTable()
{
  static const AlongRayKernels kTable{ LookAlong };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(AlongRayTable);

const AlongRayKernels& GetAlongRayKernels()
{
  return HWY_DYNAMIC_DISPATCH(AlongRayTable)();
}
} // namespace pixelexact
#endif
