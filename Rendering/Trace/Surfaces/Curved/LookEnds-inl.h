// SPDX-License-Identifier: BSD-3-Clause
// What looks at volumes leave: pairs to be solved for, and rays that stay open.
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
/// Rays in the element's units: y_a - slope_a y_k = place_a, up to slack.
struct LookRays
{
  Lanes number;
  Lanes slack;
  Lanes slope[2];
  Lanes place[2];
};

/// Where in a piece a root is looked for.
struct RootStart
{
  Lanes xi[3];       ///< in the piece
  LaneMask isInside; ///< where it was expected
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

/// Appends pairs for some lanes.
HWY_INLINE void AppendPairs(PiecePairs& pairs, LaneMask some, const LookRays& rays,
  const CurvedPiece& piece, const Lanes (&inverse)[9], const RootStart& start, Lanes kappa,
  LaneMask contracts, const Lanes (&norm)[3])
{
  const std::uint64_t which = BitsOf(some);
  if (which == 0)
  {
    return;
  }
  const PairWriter writer(pairs, which, rays.number, kappa, contracts);
  for (int a = 0; a < 2; ++a)
  {
    writer.Put(kSlopeColumn + a, rays.slope[a]);
    writer.Put(kPlaceColumn + a, rays.place[a]);
  }
  for (int n = 0; n < 9; ++n)
  {
    writer.Put(kInverseColumn + n, inverse[n]);
  }
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      writer.PutAll(kLowerColumn + d, piece.box.lower[d]);
      writer.PutAll(kUpperColumn + d, piece.box.upper[d]);
      writer.Put(kXiColumn + d, start.xi[d]);
      writer.Put(kNormColumn + d, norm[d]);
    });
  pairs.count += std::popcount(which);
}

/// Appends rays that stay open, with what their roots may be, from the piece's centre.
HWY_INLINE void AppendOpen(
  OpenRays& open, LaneMask some, const LookRays& rays, const RootBox& roots, const RootStart& start)
{
  const std::uint64_t which = BitsOf(some);
  if (which == 0)
  {
    return;
  }
  const LanesToFront toFront(which);
  const auto put = [&](int column, Lanes what) PIXELEXACT_INLINED
  { Store(toFront(what), open.Column(column) + open.count); };
  put(kOpenRayColumn, rays.number);
  put(kOpenSlackColumn, rays.slack);
  for (int a = 0; a < 2; ++a)
  {
    put(kOpenSlopeColumn + a, rays.slope[a]);
    put(kOpenPlaceColumn + a, rays.place[a]);
  }
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      put(kOpenLowerColumn + d, roots.lower[d]);
      put(kOpenUpperColumn + d, roots.upper[d]);
      put(kOpenXiColumn + d, start.xi[d]);
    });
  open.count += std::popcount(which);
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
