// SPDX-License-Identifier: BSD-3-Clause
// When a ray and a piece are solved for, and when that has come to its end.
#if defined(PIXELEXACT_PIECE_PROOF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_PIECE_PROOF_INL_H
#undef PIXELEXACT_PIECE_PROOF_INL_H
#else
#define PIXELEXACT_PIECE_PROOF_INL_H
#endif

#include "Core/Element/Matrix-inl.h"
#include "Trace/Surfaces/Curved/GatheredRays-inl.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"
#include "Trace/Surfaces/Curved/PieceMath-inl.h"

#include <algorithm>
#include <array>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Up to it a step that is held back lets a residual fall to 3/4 at least.
constexpr double kMaxKappa = 0.35;
/// Up to it, in any norm, a piece has one root at most: where the first step stays in it, that is
/// looked for by so many steps before the piece is halved.
constexpr double kMaxUnique = 0.8;
constexpr double kFewRounds = 6.0;
/// Of a pair whose residuals prove nothing.
constexpr double kNoKappa = 2.0;
/// More than rounding leaves.
constexpr double kMore = 1.0 + 1e-9;
/// Of places in xi, and of what they are found from: more than rounding leaves.
constexpr double kSlack = 1e-14;

/// Adds the rays of some lanes to a set.
HWY_INLINE void AddRays(std::uint64_t which, Lanes number, RaySet& rays)
{
  if (which == 0)
  {
    return;
  }
  std::array<double, kLanePadding> numbers;
  Store(number, numbers.data());
  for (; which != 0; which &= which - 1)
  {
    rays.Add(static_cast<int>(numbers[static_cast<std::size_t>(std::countr_zero(which))]));
  }
}

/// look.At(gathered, first, active) for packs of the rays; returns those for which it said so.
template <class PieceLook>
HWY_INLINE RaySet LookAt(const RayBundle& bundle, const RaySet& rays, PieceLook& look)
{
  const GatheredRays gathered(bundle, rays);
  RaySet unclear;
  for (int i = 0; i < gathered.Count(); i += LaneCount())
  {
    const int left = std::min(gathered.Count() - i, LaneCount());
    const LaneMask active = MaskOf((std::uint64_t{ 1 } << static_cast<unsigned>(left)) - 1U);
    const auto first = static_cast<std::size_t>(i);
    const std::uint64_t which = BitsOf(look.At(gathered, first, active));
    AddRays(which, Traits::Load(&gathered.number[first]), unclear);
  }
  return unclear;
}

/// Of pairs that a look has appended, tells the piece.
HWY_INLINE void ReportPiece(const CurvedPiece& piece, int before, PiecePairs& pairs)
{
  if (pairs.count > before)
  {
    pairs.pieces.push_back(&piece);
  }
}

/// The same of a look that appends pairs.
template <class PieceLook>
HWY_INLINE RaySet LookAt(const RayBundle& bundle, const RaySet& rays, const CurvedPiece& piece,
  PiecePairs& pairs, PieceLook& look)
{
  const int before = pairs.count;
  const RaySet unclear = LookAt(bundle, rays, look);
  ReportPiece(piece, before, pairs);
  return unclear;
}

/// Appends pairs for some lanes of a pack of rays, column by column.
class PairWriter
{
public:
  /// With what pairs of two and three unknowns have alike. `contracts`: where kappa proves; else
  /// so many rounds are left as a piece with one root at most is worth.
  HWY_INLINE PairWriter(
    PiecePairs& pairs, std::uint64_t which, Lanes ray, Lanes kappa, LaneMask contracts)
    : Pairs(pairs)
    , ToFront(which)
  {
    PutAll(kOpenColumn, 1.0);
    PutAll(kPieceColumn, static_cast<double>(pairs.pieces.size()));
    PutAll(kLastColumn, 0.0);
    Put(kRayColumn, ray);
    Put(kKappaColumn, Select(contracts, kappa, Splat(kNoKappa)));
    Put(kRoundsColumn, Select(contracts, Splat(0.0), Splat(kMaxRounds - kFewRounds)));
  }

  HWY_INLINE void Put(int column, Lanes value) const
  {
    Store(ToFront(value), Pairs.Column(column) + Pairs.count);
  }
  HWY_INLINE void PutAll(int column, double value) const
  {
    Store(Splat(value), Pairs.Column(column) + Pairs.count);
  }

private:
  PiecePairs& Pairs;
  LanesToFront ToFront;
};

/// A pair after a step of Newton's iteration, in N unknowns.
template <std::size_t N>
struct PairState
{
  Lanes frozen[N]; ///< the step with the piece's matrix
  Lanes off[N];    ///< of that: what g may be off by, seen through the matrix
  Lanes norm[N];
  Lanes moved;      ///< the step, as large as the largest of its numbers
  Lanes beyond;     ///< by how much it leaves the piece
  LaneMask isNear;  ///< g is zero, up to rounding, at the element's end up to its uncertainty
  LaneMask isThere; ///< and no step makes it smaller
};

struct PairEnd
{
  Lanes result; ///< PairResult as a number
  Lanes last;   ///< for the pair's column
  Lanes rounds; ///< for the pair's column
  LaneMask arrived;
  LaneMask isHit;
  LaneMask isFree; ///< goes on from where the step led, not from where it was held back
};

template <std::size_t N>
HWY_INLINE PairEnd EndOf(const PairState<N>& pair, Lanes kappa, Lanes last, Lanes rounds)
{
  const Lanes zero = Splat(0.0);
  const auto number = [](PairResult one) { return Splat(static_cast<double>(one)); };
  const auto sizeOf = [&](const Lanes(&v)[N]) PIXELEXACT_INLINED
  {
    Lanes largest = pair.norm[0] * Abs(v[0]);
    ForEachUpTo(Const<static_cast<int>(N) - 2>(),
      [&](auto n) PIXELEXACT_INLINED { largest = Max(largest, pair.norm[n + 1] * Abs(v[n + 1])); });
    return largest;
  };
  PairEnd end;
  end.arrived = And(pair.moved <= Splat(kArrived), pair.beyond <= Splat(kEdge));
  const Lanes residual = sizeOf(pair.frozen);
  // After a step with the piece's matrix, every root of the piece is nearer than kappa times what
  // it was before.
  const Lanes falls = (Splat(1.0) + kappa) * kappa / (Splat(1.0) - kappa);
  // Both residuals are off by what g may be.
  const LaneMask contracts = kappa < Splat(1.0);
  const LaneMask miss = And(contracts,
    And(zero < last, falls * last * Splat(1.0 + 1e-6) + Splat(2.0) * sizeOf(pair.off) < residual));
  end.rounds = rounds + Splat(1.0);
  const LaneMask stays = pair.beyond <= zero;
  const LaneMask goesOn = And(And(IsFinite(residual), end.rounds <= Splat(kMaxRounds)),
    Or(Or(contracts, stays), pair.isNear));
  end.isHit = Or(Or(end.arrived, pair.isThere), AndNot(pair.isNear, goesOn));
  end.isFree =
    Or(pair.isNear, AndNot(stays, And(contracts, end.rounds >= Splat(0.5 * kMaxRounds))));
  end.last = Select(end.isFree, zero, residual);
  end.result = Select(goesOn, number(PairResult::Again), number(PairResult::Unclear));
  end.result = Select(miss, number(PairResult::Miss), end.result);
  end.result = Select(end.isHit, number(PairResult::Hit), end.result);
  return end;
}

/// EndOf the pairs from i on; writes their columns and results.
template <std::size_t N>
HWY_INLINE PairEnd EndStep(const PairState<N>& pair, PiecePairs& pairs, int i, double* result)
{
  const auto load = [&](int column) PIXELEXACT_INLINED
  { return NumberTraits<Lanes>::Load(pairs.Column(column) + i); };
  const PairEnd end = EndOf(pair, load(kKappaColumn), load(kLastColumn), load(kRoundsColumn));
  Store(end.result, result + i);
  Store(end.last, pairs.Column(kLastColumn) + i);
  Store(end.rounds, pairs.Column(kRoundsColumn) + i);
  return end;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
