// SPDX-License-Identifier: BSD-3-Clause
// Selection of pairs of ray and piece for Newton's iteration, and its end conditions.
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
/// Largest kappa at which a clamped step reduces the residual to 3/4 or less.
constexpr double kMaxKappa = 0.35;
/// Largest norm with which a piece has at most one root. If the first step stays in the piece,
/// kFewRounds steps search the root before the piece is subdivided.
constexpr double kMaxUnique = 0.8;
constexpr double kFewRounds = 6.0;
/// Kappa of a pair whose residuals prove nothing.
constexpr double kNoKappa = 2.0;
/// Factor that exceeds rounding.
constexpr double kMore = 1.0 + 1e-9;
/// Bound of the rounding of positions in xi, and of the numbers that they are computed from.
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

/// Calls look.At(gathered, first, active) for packs of the rays. Returns the rays of the lanes that
/// it returned.
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

/// Records the piece of the pairs that a look has appended.
HWY_INLINE void ReportPiece(const CurvedPiece& piece, int before, PiecePairs& pairs)
{
  if (pairs.count > before)
  {
    pairs.pieces.push_back(&piece);
  }
}

/// The same for a look that appends pairs.
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
  /// Writes the columns common to pairs of two and three unknowns. `contracts`: lanes where kappa
  /// proves convergence; in the others, kFewRounds rounds remain.
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
  Lanes off[N];    ///< the error of g, transformed by the matrix
  Lanes norm[N];
  Lanes moved;  ///< largest magnitude of the step's coordinates
  Lanes beyond; ///< distance by which the step leaves the piece
  /// g vanishes up to rounding or, at the element's boundary, up to the element's uncertainty.
  LaneMask isNear;
  LaneMask isThere; ///< the same, and no step reduces g
};

struct PairEnd
{
  Lanes result; ///< PairResult as a number
  Lanes last;   ///< for the pair's column
  Lanes rounds; ///< for the pair's column
  LaneMask arrived;
  LaneMask isHit;
  LaneMask isFree; ///< continues from the step's end, not from the clamped point
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
  // After a step with the piece's matrix, the distance to every root of the piece is below kappa
  // times the one before.
  const Lanes falls = (Splat(1.0) + kappa) * kappa / (Splat(1.0) - kappa);
  // Both residuals have the error of g.
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

/// Evaluates EndOf for the pairs from i on; writes their columns and results.
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
