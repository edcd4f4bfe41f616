// SPDX-License-Identifier: BSD-3-Clause
// Results of looks at volumes: pairs to be solved, and rays that stay open.
#if defined(PIXELEXACT_LOOK_ENDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_LOOK_ENDS_INL_H
#undef PIXELEXACT_LOOK_ENDS_INL_H
#else
#define PIXELEXACT_LOOK_ENDS_INL_H
#endif

#include "Trace/Surfaces/Curved/OpenRays.h"
#include "Trace/Surfaces/Curved/PieceNorms-inl.h"
#include "Trace/Surfaces/Curved/PieceProof-inl.h"
#include "Trace/Surfaces/Curved/RootBox-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Rays in the element's units: y_a - slope_a y_k = place_a, with an error of at most `slack`.
struct LookRays
{
  Lanes number;
  Lanes slack;
  Lanes slope[2];
  Lanes place[2];
};

/// If a piece may hold two roots of a ray, the side on which this root lies: normal . xi >= least.
struct RootSide
{
  Lanes normal[3];
  Lanes least;
};

/// The point of a piece where the search of a root starts.
struct RootStart
{
  Lanes xi[3];       ///< in the piece
  LaneMask isInside; ///< the root is expected there
};

HWY_INLINE RootStart StartOf(Shape shape, const CurvedPiece& piece, const Lanes (&expected)[3])
{
  Lanes lower[3];
  Lanes upper[3];
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      lower[d] = Splat(piece.box.lower[d]);
      upper[d] = Splat(piece.box.upper[d]);
    });
  RootStart start;
  ClampTo(shape, lower, upper, expected, start.xi);
  Lanes off = Splat(0.0);
  ForEachAxis([&](auto d) PIXELEXACT_INLINED { off = Max(off, Abs(expected[d] - start.xi[d])); });
  start.isInside = off <= Splat(kEdge);
  return start;
}

/// Appends pairs for the lanes `some`, each with at most one root on its side.
HWY_INLINE void AppendPairs(PiecePairs& pairs, LaneMask some, const LookRays& rays,
  const CurvedPiece& piece, const RootStart& start, const RootSide& side)
{
  const std::uint64_t which = BitsOf(some);
  if (which == 0)
  {
    return;
  }
  const PairWriter writer(pairs, which, rays.number, Splat(kNoKappa), MaskOf(0));
  for (int a = 0; a < 2; ++a)
  {
    writer.Put(kSlopeColumn + a, rays.slope[a]);
    writer.Put(kPlaceColumn + a, rays.place[a]);
  }
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      writer.PutAll(kLowerColumn + d, piece.box.lower[d]);
      writer.PutAll(kUpperColumn + d, piece.box.upper[d]);
      writer.Put(kXiColumn + d, start.xi[d]);
      writer.Put(kSideColumn + d, side.normal[d]);
    });
  writer.Put(kMinColumn, side.least);
  pairs.count += std::popcount(which);
}

/// Writes columns of some lanes after the existing rays.
class OpenWriter
{
public:
  HWY_INLINE OpenWriter(OpenRays& open, std::uint64_t which)
    : Open(open)
    , ToFront(which)
  {
  }
  HWY_INLINE void Put(int column, Lanes what) const
  {
    Store(ToFront(what), Open.Column(column) + Open.count);
  }

private:
  OpenRays& Open;
  LanesToFront ToFront;
};

HWY_INLINE void PutRays(const OpenWriter& writer, const LookRays& rays, const RootBox& roots)
{
  writer.Put(kOpenRayColumn, rays.number);
  writer.Put(kOpenSlackColumn, rays.slack);
  for (int a = 0; a < 2; ++a)
  {
    writer.Put(kOpenSlopeColumn + a, rays.slope[a]);
    writer.Put(kOpenPlaceColumn + a, rays.place[a]);
  }
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      writer.Put(kOpenLowerColumn + d, roots.lower[d]);
      writer.Put(kOpenUpperColumn + d, roots.upper[d]);
    });
}

/// Appends rays with the boxes of their roots, relative to the piece's centre.
HWY_INLINE void AppendNear(
  OpenRays& near, LaneMask some, const LookRays& rays, const RootBox& roots)
{
  const std::uint64_t which = BitsOf(some);
  if (which != 0)
  {
    PutRays(OpenWriter(near, which), rays, roots);
    near.count += std::popcount(which);
  }
}

/// Appends rays that stay open, with the boxes of their roots, a point near the root, and its side.
HWY_INLINE void AppendOpen(OpenRays& open, LaneMask some, const LookRays& rays,
  const RootBox& roots, const RootStart& start, const RootSide& side)
{
  const std::uint64_t which = BitsOf(some);
  if (which == 0)
  {
    return;
  }
  const OpenWriter writer(open, which);
  PutRays(writer, rays, roots);
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      writer.Put(kOpenXiColumn + d, start.xi[d]);
      writer.Put(kOpenSideColumn + d, side.normal[d]);
    });
  writer.Put(kOpenLeastColumn, side.least);
  open.count += std::popcount(which);
}

HWY_INLINE LookRays LoadRays(OpenRays& open, int i)
{
  const auto load = [&](int column) PIXELEXACT_INLINED
  { return Traits::Load(open.Column(column) + i); };
  return { load(kOpenRayColumn), load(kOpenSlackColumn),
    { load(kOpenSlopeColumn), load(kOpenSlopeColumn + 1) },
    { load(kOpenPlaceColumn), load(kOpenPlaceColumn + 1) } };
}

/// Calls at(first, active) for packs of `count` open rays. Returns the rays of the lanes that it
/// returned.
template <class Look>
HWY_INLINE RaySet LookAtOpen(
  OpenRays& open, int count, const CurvedPiece& piece, PiecePairs& pairs, Look&& at)
{
  const int before = pairs.count;
  RaySet unclear;
  for (int i = 0; i < count; i += LaneCount())
  {
    const int left = std::min(count - i, LaneCount());
    const LaneMask active = MaskOf((std::uint64_t{ 1 } << static_cast<unsigned>(left)) - 1U);
    // Rays that stay open may overwrite packs that have been read.
    const Lanes number = Traits::Load(open.Column(kOpenRayColumn) + i);
    AddRays(BitsOf(at(i, active)), number, unclear);
  }
  ReportPiece(piece, before, pairs);
  return unclear;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
