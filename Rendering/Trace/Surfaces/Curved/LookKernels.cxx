// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/LookKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Curved/CurvedEquations-inl.h"
#include "Trace/Surfaces/Curved/LookEnds-inl.h"
#include "Trace/Surfaces/Curved/LookKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// So often the place of a ray's roots in a piece is narrowed by what is known of it.
constexpr int kNarrowings = 2;

/// A piece, as rays of a bundle see it.
class PieceLook
{
public:
  HWY_INLINE PieceLook(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
    PiecePairs& pairs, OpenRays& open)
    : Frame(frame)
    , Piece(piece)
    , Pairs(pairs)
    , Open(open)
    , Across{ static_cast<std::size_t>(bundle.axes[0]), static_cast<std::size_t>(bundle.axes[1]) }
    , AlongAxis(static_cast<std::size_t>(bundle.axes[2]))
    , Along((bundle.z0 - frame.centre[bundle.axes[2]]) * frame.inverseSize)
    , Curves(piece)
  {
  }

  /// Of a pack of rays, those that the piece bends too much for. Appends pairs and open rays.
  HWY_INLINE LaneMask At(const GatheredRays& gathered, std::size_t i, LaneMask active)
  {
    Lanes m[3][3];
    Lanes radius[3][3];
    Lanes g[3];
    Lanes rounding[3];
    Lanes bend[3];
    LookRays rays;
    rays.number = Traits::Load(&gathered.number[i]);
    rays.slack = Traits::Load(&gathered.slack[i]) * Splat(Frame.inverseSize);
    auto& slope = rays.slope;
    auto& q = rays.place;
    for (std::size_t a = 0; a < 2; ++a)
    {
      const std::size_t c = Across[a];
      const std::size_t k = AlongAxis;
      const Lanes s = Traits::Load(&gathered.slope[a][i]);
      slope[a] = s;
      q[a] = (Traits::Load(&gathered.place[a][i]) - Splat(Frame.centre[static_cast<int>(c)])) *
          Splat(Frame.inverseSize) -
        s * Splat(Along);
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED
        {
          m[a][d] = Splat(Piece.slope[c][d]) - s * Splat(Piece.slope[k][d]);
          radius[a][d] = Splat(Piece.radius[c][d]) + Abs(s) * Splat(Piece.radius[k][d]);
        });
      g[a] = Splat(Piece.value[c]) - s * Splat(Piece.value[k]) - q[a];
      rounding[a] = Splat(Piece.error[c]) + Abs(s) * Splat(Piece.error[k]) +
        Splat(8.0 * kUnitRoundoff) * (Abs(q[a]) + Abs(Splat(Along))) + rays.slack;
      bend[a] = Splat(Piece.bend[c]) + Abs(s) * Splat(Piece.bend[k]);
    }
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        m[2][d] = Splat(Piece.slope[3][d]);
        radius[2][d] = Splat(Piece.radius[3][d]);
      });
    g[2] = Splat(Piece.value[3]);
    rounding[2] = Splat(Piece.error[3]);
    bend[2] = Splat(Piece.bend[3]);
    Lanes inverse[9];
    InverseOf(m, inverse);
    Lanes first[3];
    Product(inverse, g, first);
    const auto times = [&](auto r, const Lanes(&of)[3]) PIXELEXACT_INLINED
    {
      return Abs(inverse[3 * r]) * of[0] + Abs(inverse[3 * r + 1]) * of[1] +
        Abs(inverse[3 * r + 2]) * of[2];
    };
    // NaNs neither miss nor decide.
    const Lanes zero = Splat(0.0);
    LaneMask misses = zero < zero;
    RootBox roots;
    Lanes known[3];
    Lanes step[3];
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        known[r] = times(r, rounding);
        step[r] = zero - first[r];
        // A root in the piece lies in centre - first +- off, however large that is.
        const Lanes off = (known[r] + times(r, bend)) * Splat(kMore) + Splat(kSlack);
        const Lanes half = Splat(Piece.half[r] * kMore);
        misses = Or(misses, half + off < Abs(first[r]));
        roots.lower[r] = Max(zero - half, step[r] - off);
        roots.upper[r] = Min(half, step[r] + off);
      });
    LaneMask open = AndNot(active, misses);
    if (None(open))
    {
      return open;
    }
    const LaneMask isFinite =
      IsFinite(first[0] + first[1] + first[2] + known[0] + known[1] + known[2]);
    if (Frame.shape != Shape::Hexahedron)
    {
      open = AndNot(open, And(isFinite, KeepToPiece(Frame.shape, Piece, roots)));
      if (None(open))
      {
        return open;
      }
    }
    // |M^-1| times the radii.
    Lanes K[3][3];
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        ForEachAxis(
          [&](auto d) PIXELEXACT_INLINED
          {
            K[r][d] = Abs(inverse[3 * r]) * radius[0][d] + Abs(inverse[3 * r + 1]) * radius[1][d] +
              Abs(inverse[3 * r + 2]) * radius[2][d];
          });
      });
    // Max may lose a NaN, not so a sum.
    Lanes all =
      K[0][0] + K[0][1] + K[0][2] + K[1][0] + K[1][1] + K[1][2] + K[2][0] + K[2][1] + K[2][2];
    Lanes unique;
    if (Piece.curves)
    {
      const CurvedEquations equations(Curves, Across, AlongAxis, slope, inverse, first, known);
      for (int pass = 0; pass < kNarrowings; ++pass)
      {
        open = AndNot(open, And(isFinite, equations.Narrow(roots, step)));
        if (None(open))
        {
          return open;
        }
      }
      Lanes near[3][3];
      equations.Spread(roots, near);
      ForEachAxis(
        [&](auto r) PIXELEXACT_INLINED
        {
          step[r] = Max(Min(step[r], roots.upper[r]), roots.lower[r]);
          all = all + near[r][0] + near[r][1] + near[r][2];
          ForEachAxis([&](auto d) PIXELEXACT_INLINED { near[r][d] = Min(near[r][d], K[r][d]); });
        });
      unique = LeastNorm(near);
    }
    else
    {
      unique = LeastNorm(K);
    }
    MaximumNorm norm;
    const Lanes kappa = ChooseNorm(Frame.shape, K, norm);
    Lanes expected[3];
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { expected[d] = Splat(Piece.centre[d]) + step[d]; });
    const RootStart start = StartOf(Frame.shape, Piece, expected);
    const LaneMask isUnique = And(IsFinite(all), unique <= Splat(kMostUnique));
    const LaneMask contracts = kappa <= Splat(kMostKappa);
    const LaneMask pair =
      And(open, Or(And(IsFinite(all), contracts), And(isUnique, start.isInside)));
    AppendPairs(Pairs, pair, rays, Piece, inverse, start, kappa, contracts, norm.w);
    open = AndNot(open, pair);
    if (!Piece.curves)
    {
      return open;
    }
    const LaneMask closer = And(open, isUnique);
    AppendOpen(Open, closer, rays, roots, start);
    return AndNot(open, closer);
  }

private:
  const ElementFrame& Frame;
  const CurvedPiece& Piece;
  PiecePairs& Pairs;
  OpenRays& Open;
  std::size_t Across[2];
  std::size_t AlongAxis;
  double Along;
  Curvature Curves;
};

RaySet Look(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
  const RaySet& rays, PiecePairs& pairs, OpenRays& open)
{
  open.count = 0;
  PieceLook look(bundle, frame, piece, pairs, open);
  return LookAt(bundle, rays, piece, pairs, look);
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
