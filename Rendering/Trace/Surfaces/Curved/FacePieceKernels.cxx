// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/FacePieceKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Curved/FaceMath-inl.h"
#include "Trace/Surfaces/Curved/GatheredRays-inl.h"
#include "Trace/Surfaces/Curved/LookKernels.h"
#include "Trace/Surfaces/Curved/PieceProof-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// A piece of a face, viewed along rays of a bundle.
class FaceLook
{
public:
  HWY_INLINE FaceLook(
    const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece, PiecePairs& pairs)
    : Frame(frame)
    , Piece(piece)
    , Pairs(pairs)
    , Along((bundle.z0 - frame.centre[bundle.axes[2]]) * frame.inverseSize)
  {
    const FaceChart& chart = frame.chart;
    for (std::size_t a = 0; a < 3; ++a)
    {
      Axis[a] = static_cast<std::size_t>(bundle.axes[a]);
      const std::size_t c = Axis[a];
      Rest[a] = piece.error[c] + piece.bend[c];
      for (std::size_t j = 0; j < 2; ++j)
      {
        const auto d = static_cast<std::size_t>(chart.free[j]);
        const auto w = static_cast<std::size_t>(chart.across);
        Tangent[a][j] = piece.slope[c][d] + chart.along[j] * piece.slope[c][w];
        Radius[a][j] = (piece.radius[c][d] + std::abs(chart.along[j]) * piece.radius[c][w]) * kMore;
      }
    }
  }

  /// Tests a pack of rays. Appends pairs, and returns the rays for which the piece bends too much.
  HWY_INLINE LaneMask At(const GatheredRays& rays, std::size_t i, LaneMask active)
  {
    Lanes m[2][2];
    Lanes g[2];
    Lanes rest[2]; ///< what the equations may be off by over the piece
    Lanes slope[2];
    Lanes q[2];
    const std::size_t k = Axis[2];
    ForBoth(
      [&](auto a) PIXELEXACT_INLINED
      {
        const std::size_t c = Axis[a];
        const Lanes s = Traits::Load(&rays.slope[a][i]);
        slope[a] = s;
        q[a] = (Traits::Load(&rays.place[a][i]) - Splat(Frame.centre[static_cast<int>(c)])) *
            Splat(Frame.inverseSize) -
          s * Splat(Along);
        ForBoth([&](auto j) PIXELEXACT_INLINED
          { m[a][j] = Splat(Tangent[a][j]) - s * Splat(Tangent[2][j]); });
        g[a] = Splat(Piece.value[c]) - s * Splat(Piece.value[k]) - q[a];
        rest[a] = Splat(Rest[a]) + Abs(s) * Splat(Rest[2]) +
          Splat(8.0 * kUnitRoundoff) * (Abs(q[a]) + Splat(std::abs(Along))) +
          Traits::Load(&rays.slack[i]) * Splat(Frame.inverseSize);
      });
    // A root in the piece lies in centre - first +- off, for any size of these. Multiplied by the
    // determinant, first and off exclude most rays without a division.
    const Lanes zero = Splat(0.0);
    const Lanes cofactor[2][2] = { { m[1][1], zero - m[0][1] }, { zero - m[1][0], m[0][0] } };
    const Lanes determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    const Lanes size = Abs(determinant);
    // NaNs neither miss nor decide.
    LaneMask misses = zero < zero;
    Lanes first[2];
    Lanes off[2];
    ForBoth(
      [&](auto r) PIXELEXACT_INLINED
      {
        first[r] = cofactor[r][0] * g[0] + cofactor[r][1] * g[1];
        off[r] = (Abs(cofactor[r][0]) * rest[0] + Abs(cofactor[r][1]) * rest[1]) * Splat(kMore) +
          Splat(kSlack) * size;
        const Lanes half = Splat(Piece.half[Frame.chart.free[r]] * kMore);
        misses = Or(misses, half * size + off[r] < Abs(first[r]));
      });
    LaneMask open = AndNot(active, misses);
    if (None(open))
    {
      return open;
    }
    const Lanes scale = Splat(1.0) / determinant;
    Lanes inverse[2][2];
    Lanes all = zero;
    Lanes step[2];
    Lanes lower[2];
    Lanes upper[2];
    ForBoth(
      [&](auto r) PIXELEXACT_INLINED
      {
        inverse[r][0] = cofactor[r][0] * scale;
        inverse[r][1] = cofactor[r][1] * scale;
        step[r] = zero - first[r] * scale;
        off[r] = off[r] * Abs(scale);
        all = all + step[r] + off[r];
        const Lanes half = Splat(Piece.half[Frame.chart.free[r]] * kMore);
        lower[r] = Max(zero - half, step[r] - off[r]);
        upper[r] = Min(half, step[r] + off[r]);
      });
    if (Frame.chart.collapses)
    {
      open = AndNot(open, And(IsFinite(all), IsBeside(lower, upper)));
      if (None(open))
      {
        return open;
      }
    }
    // |M^-1| times the radii.
    Lanes K[2][2];
    ForBoth(
      [&](auto r) PIXELEXACT_INLINED
      {
        ForBoth(
          [&](auto j) PIXELEXACT_INLINED
          {
            const auto radius = [&](std::size_t a) PIXELEXACT_INLINED
            { return Splat(Radius[a][j]) + Abs(slope[a]) * Splat(Radius[2][j]); };
            K[r][j] = Abs(inverse[r][0]) * radius(0) + Abs(inverse[r][1]) * radius(1);
            // Max may drop a NaN; a sum keeps it.
            all = all + K[r][j];
          });
      });
    Lanes norm[2];
    const Lanes kappa = ChooseNorm(Frame.chart.collapses, K, norm);
    Lanes from[2];
    Lanes to[2];
    Lanes start[2];
    Lanes at[2];
    ForBoth(
      [&](auto j) PIXELEXACT_INLINED
      {
        const int d = Frame.chart.free[j];
        from[j] = Splat(Piece.box.lower[d]);
        to[j] = Splat(Piece.box.upper[d]);
        start[j] = Splat(Piece.centre[d]) + step[j];
      });
    ClampTo(Frame.chart.collapses, from, to, start, at);
    LaneMask within = LeastNorm(K) <= Splat(kMaxUnique);
    ForBoth([&](auto j) PIXELEXACT_INLINED
      { within = And(within, Abs(start[j] - at[j]) <= Splat(kEdge)); });
    const LaneMask contracts = kappa <= Splat(kMaxKappa);
    const LaneMask pair = And(open, And(IsFinite(all), Or(contracts, within)));
    const std::uint64_t which = BitsOf(pair);
    if (which == 0)
    {
      return open;
    }
    const PairWriter writer(Pairs, which, Traits::Load(&rays.number[i]), kappa, contracts);
    ForBoth(
      [&](auto j) PIXELEXACT_INLINED
      {
        writer.Put(kSlopeColumn + j, slope[j]);
        writer.Put(kPlaceColumn + j, q[j]);
        writer.Put(kInverseColumn + 2 * j, inverse[j][0]);
        writer.Put(kInverseColumn + 2 * j + 1, inverse[j][1]);
        writer.PutAll(kLowerColumn + j, Piece.box.lower[Frame.chart.free[j]]);
        writer.PutAll(kUpperColumn + j, Piece.box.upper[Frame.chart.free[j]]);
        writer.Put(kXiColumn + Frame.chart.free[j], at[j]);
        writer.Put(kNormColumn + j, norm[j]);
      });
    writer.Put(kXiColumn + Frame.chart.across, AcrossAt(Frame.chart, at));
    Pairs.count += std::popcount(which);
    return AndNot(open, pair);
  }

private:
  /// A box around the centre does not meet the piece, whose ends in u depend on v.
  [[nodiscard]] HWY_INLINE LaneMask IsBeside(const Lanes (&lower)[2], const Lanes (&upper)[2]) const
  {
    const int u = Frame.chart.free[0];
    const Lanes centre = Splat(Piece.centre[Frame.chart.free[1]]);
    const Lanes from = Splat(1.0 + Piece.centre[u]);
    const Lanes half = Splat(0.5);
    const Lanes most = Max(half * (Splat(1.0) - (centre + lower[1])), Splat(0.0));
    const Lanes least = Max(half * (Splat(1.0) - (centre + upper[1])), Splat(0.0));
    const Lanes last = Splat(1.0 + Piece.box.upper[u]) * most - from + Splat(kSlack);
    const Lanes first = Splat(1.0 + Piece.box.lower[u]) * least - from - Splat(kSlack);
    return Min(upper[0], last) < Max(lower[0], first);
  }

  const ElementFrame& Frame;
  const CurvedPiece& Piece;
  PiecePairs& Pairs;
  double Along;
  std::size_t Axis[3];
  double Tangent[3][2]; ///< derivatives on the face, of the coordinates across and along the rays
  double Radius[3][2];
  double Rest[3]; ///< largest deviation of these coordinates from value plus slopes
};

RaySet LookAtFace(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
  const RaySet& rays, PiecePairs& pairs)
{
  FaceLook look(bundle, frame, piece, pairs);
  return LookAt(bundle, rays, piece, pairs, look);
}

/// One step of Newton's iteration, with the slopes at xi if it stays in the piece, and with the
/// piece's own matrix if it must be clamped.
void StepOnFace(const RayBundle& bundle, const ElementFrame& frame, const double* values,
  std::size_t stride, PiecePairs& pairs, double* const position[3], double* result)
{
  const FaceChart& chart = frame.chart;
  const auto k = static_cast<std::size_t>(bundle.axes[2]);
  const Lanes least[2] = { Splat(-1.0), Splat(-1.0) };
  const Lanes most[2] = { Splat(1.0), Splat(1.0) };
  for (int i = 0; i < pairs.count; i += LaneCount())
  {
    const auto load = [&](int column) PIXELEXACT_INLINED
    { return Traits::Load(pairs.Column(column) + i); };
    const auto value = [&](std::size_t n) PIXELEXACT_INLINED
    { return Traits::Load(values + n * stride + i); };
    Lanes tangent[3][2];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const auto c = static_cast<std::size_t>(d);
        tangent[c][0] = value(4 + 2 * c);
        tangent[c][1] = value(5 + 2 * c);
      });
    Lanes m[2][2];
    Lanes g[2];
    Lanes frozenInverse[2][2];
    PairState<2> pair;
    ForBoth(
      [&](auto a) PIXELEXACT_INLINED
      {
        const auto c = static_cast<std::size_t>(bundle.axes[a]);
        const Lanes s = load(kSlopeColumn + a);
        ForBoth([&](auto j) PIXELEXACT_INLINED { m[a][j] = tangent[c][j] - s * tangent[k][j]; });
        g[a] = value(c) - s * value(k) - load(kPlaceColumn + a);
        frozenInverse[a][0] = load(kInverseColumn + 2 * a);
        frozenInverse[a][1] = load(kInverseColumn + 2 * a + 1);
      });
    Lanes inverse[2][2];
    InverseOf(m, inverse);
    Lanes at[2];
    Lanes lower[2];
    Lanes upper[2];
    Lanes step[2];
    Lanes next[2];
    Lanes back[2];
    ForBoth(
      [&](auto j) PIXELEXACT_INLINED
      {
        at[j] = load(kXiColumn + chart.free[j]);
        lower[j] = load(kLowerColumn + j);
        upper[j] = load(kUpperColumn + j);
        step[j] = inverse[j][0] * g[0] + inverse[j][1] * g[1];
        next[j] = at[j] - step[j];
        pair.frozen[j] = frozenInverse[j][0] * g[0] + frozenInverse[j][1] * g[1];
        pair.norm[j] = load(kNormColumn + j);
        back[j] = at[j] - pair.frozen[j];
      });
    Lanes inside[2];
    Lanes held[2];
    ClampTo(chart.collapses, lower, upper, next, inside);
    ClampTo(chart.collapses, lower, upper, back, held);
    Lanes onFace[2];
    ClampTo(chart.collapses, least, most, next, onFace);
    const auto apart = [](const Lanes(&a)[2], const Lanes(&b)[2]) PIXELEXACT_INLINED
    { return Max(Abs(a[0] - b[0]), Abs(a[1] - b[1])); };
    pair.moved = Max(Abs(step[0]), Abs(step[1]));
    pair.beyond = apart(next, inside);
    const Closeness<2> close(g, frame.rounding, frame.tolerance, Splat(0.0) < apart(next, onFace));
    pair.isNear = close.isNear;
    pair.isThere = And(close.isNear, Or(close.isExact, apart(inside, at) <= Splat(kArrived)));
    ForBoth(
      [&](auto j) PIXELEXACT_INLINED
      {
        pair.off[j] =
          close.tolerance * (Abs(frozenInverse[j][0]) + Abs(frozenInverse[j][1])) + Splat(kEdge);
      });
    const PairEnd end = EndStep(pair, pairs, i, result);
    Lanes xi[2];
    ForBoth(
      [&](auto j) PIXELEXACT_INLINED
      {
        const Lanes moved = Select(end.isFree, inside[j], held[j]);
        const Lanes found = Select(end.arrived, inside[j], at[j]);
        xi[j] = Select(end.isHit, found, moved);
        Store(xi[j], pairs.Column(kXiColumn + chart.free[j]) + i);
      });
    Store(AcrossAt(chart, xi), pairs.Column(kXiColumn + chart.across) + i);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const auto c = static_cast<std::size_t>(d);
        const Lanes last = tangent[c][0] * step[0] + tangent[c][1] * step[1];
        const Lanes y = value(c) - Select(end.arrived, last, Splat(0.0));
        Store(Splat(frame.centre[d]) + Splat(frame.size) * y, position[d] + i);
      });
  }
}

const FacePieceKernels& FacePieceTable()
{
  static const FacePieceKernels kTable{ LookAtFace, StepOnFace };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(FacePieceTable);

const FacePieceKernels& GetFacePieceKernels()
{
  return HWY_DYNAMIC_DISPATCH(FacePieceTable)();
}
} // namespace pixelexact
#endif
