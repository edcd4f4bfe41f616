// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/CloserLookKernels.cxx"
#include <hwy/foreach_target.h>

#include "Trace/Surfaces/Curved/CurvedEquations-inl.h"
#include "Trace/Surfaces/Curved/LookEnds-inl.h"
#include "Trace/Surfaces/Curved/LookKernels.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Count of narrowings of a ray's box of roots by the derivatives at a point near them.
constexpr int kCloserNarrowings = 2;
/// Bounds of rounding: of values, as a multiple of the element's tolerance; of slopes, relative to
/// the piece's largest slope and to 1.
constexpr double kValueRounding = 4.0;
constexpr double kSlopeRounding = 1e-12;
/// A further look is worth its cost if the box of roots shrank along a direction by this factor.
constexpr double kShrinks = 0.5;

/// A piece, viewed along rays from points near their roots.
class PieceCloserLook
{
public:
  HWY_INLINE PieceCloserLook(const RayBundle& bundle, const ElementFrame& frame,
    const CurvedPiece& piece, OpenRays& open, PiecePairs& pairs)
    : Frame(frame)
    , Piece(piece)
    , Open(open)
    , Pairs(pairs)
    , Across{ static_cast<std::size_t>(bundle.axes[0]), static_cast<std::size_t>(bundle.axes[1]) }
    , AlongAxis(static_cast<std::size_t>(bundle.axes[2]))
    , Curves(piece)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      double largest = 1.0;
      for (std::size_t d = 0; d < 3; ++d)
      {
        largest = std::max(largest, std::fabs(piece.slope[c][d]) + piece.radius[c][d]);
      }
      // Both the slopes at the point and those elsewhere have this error relative to the second
      // derivatives.
      for (double& rest : Curves.rest[c])
      {
        rest = 2.0 * rest + kSlopeRounding * largest;
      }
    }
  }

  /// Tests the pack of open rays from i on, in the lanes `active`. Appends pairs and the rays that
  /// stay open, and returns the others that do not miss. value(n) loads row n of the kernels'
  /// values.
  template <class Value>
  HWY_INLINE LaneMask At(int i, LaneMask active, const Value& value)
  {
    const auto load = [&](int column) PIXELEXACT_INLINED
    { return Traits::Load(Open.Column(column) + i); };
    const auto slopeAt = [&](std::size_t c, std::size_t d) PIXELEXACT_INLINED
    { return value(4 + 3 * c + d); };
    const LookRays rays = LoadRays(Open, i);
    const RootSide side{ { load(kOpenSideColumn), load(kOpenSideColumn + 1),
                           load(kOpenSideColumn + 2) },
      load(kOpenLeastColumn) };
    const Lanes tolerance = Splat(kValueRounding * Frame.tolerance);
    Lanes m[3][3];
    Lanes g[3];
    Lanes rounding[3];
    for (int a = 0; a < 2; ++a)
    {
      const std::size_t c = Across[a];
      const Lanes s = rays.slope[a];
      const Lanes q = rays.place[a];
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED { m[a][d] = slopeAt(c, d) - s * slopeAt(AlongAxis, d); });
      g[a] = value(c) - s * value(AlongAxis) - q;
      rounding[a] = tolerance * (Splat(1.0) + Abs(s) + Abs(q)) + rays.slack;
    }
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { m[2][d] = slopeAt(3, d); });
    g[2] = value(3);
    rounding[2] = tolerance;
    Lanes inverse[9];
    InverseOf(m, inverse);
    Lanes first[3];
    Product(inverse, g, first);
    Lanes known[3];
    Lanes point[3];
    RootBox roots; // from the point
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        known[r] = (Abs(inverse[3 * r]) * rounding[0] + Abs(inverse[3 * r + 1]) * rounding[1] +
                     Abs(inverse[3 * r + 2]) * rounding[2]) *
            Splat(kMore) +
          Splat(kSlack);
        point[r] = load(kOpenXiColumn + r) - Splat(Piece.centre[r]);
        roots.lower[r] = load(kOpenLowerColumn + r) - point[r];
        roots.upper[r] = load(kOpenUpperColumn + r) - point[r];
      });
    // NaNs neither miss nor decide.
    const LaneMask isFinite =
      IsFinite(first[0] + first[1] + first[2] + known[0] + known[1] + known[2]);
    const CurvedEquations equations(Curves, Across, AlongAxis, rays.slope, inverse, first, known);
    LaneMask open = active;
    Lanes step[3];
    for (int pass = 0; pass < kCloserNarrowings && !None(open); ++pass)
    {
      open = AndNot(open, And(isFinite, equations.Narrow(roots, step)));
    }
    RootBox fromCentre;
    Lanes expected[3];
    LaneMask shrinks = MaskOf(0);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const Lanes width = load(kOpenUpperColumn + d) - load(kOpenLowerColumn + d);
        fromCentre.lower[d] = roots.lower[d] + point[d];
        fromCentre.upper[d] = roots.upper[d] + point[d];
        shrinks = Or(shrinks, roots.upper[d] - roots.lower[d] <= Splat(kShrinks) * width);
        expected[d] = load(kOpenXiColumn + d) + Max(Min(step[d], roots.upper[d]), roots.lower[d]);
      });
    if (Frame.shape != Shape::Hexahedron)
    {
      open = AndNot(open, And(isFinite, KeepToPiece(Frame.shape, Piece, fromCentre)));
    }
    if (None(open))
    {
      return open;
    }
    Lanes near[3][3];
    equations.Spread(roots, near);
    const Lanes all = near[0][0] + near[0][1] + near[0][2] + near[1][0] + near[1][1] + near[1][2] +
      near[2][0] + near[2][1] + near[2][2];
    const LaneMask isUnique =
      And(And(isFinite, IsFinite(all)), LeastNorm(near) <= Splat(kMaxUnique));
    const RootStart start = StartOf(Frame.shape, Piece, expected);
    const LaneMask pair = And(open, And(isUnique, start.isInside));
    AppendPairs(Pairs, pair, rays, Piece, start, side);
    open = AndNot(open, pair);
    const LaneMask again = And(open, And(isFinite, Or(isUnique, shrinks)));
    AppendOpen(Open, again, rays, fromCentre, start, side);
    return AndNot(open, again);
  }

private:
  const ElementFrame& Frame;
  const CurvedPiece& Piece;
  OpenRays& Open;
  PiecePairs& Pairs;
  std::size_t Across[2];
  std::size_t AlongAxis;
  Curvature Curves;
};

RaySet LookCloser(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
  const double* values, std::size_t stride, OpenRays& open, PiecePairs& pairs)
{
  const int count = open.count;
  // Rays that stay open overwrite packs that have been read.
  open.count = 0;
  PieceCloserLook look(bundle, frame, piece, open, pairs);
  return LookAtOpen(open, count, piece, pairs,
    [&](int i, LaneMask active) PIXELEXACT_INLINED
    {
      const auto value = [&](std::size_t n) PIXELEXACT_INLINED
      { return Traits::Load(values + n * stride + i); };
      return look.At(i, active, value);
    });
}

const CloserLookKernels& CloserLookTable()
{
  static const CloserLookKernels kTable{ LookCloser };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(CloserLookTable);

const CloserLookKernels& GetCloserLookKernels()
{
  return HWY_DYNAMIC_DISPATCH(CloserLookTable)();
}
} // namespace pixelexact
#endif
