// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/Curved/PieceKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Core/Math/Rounding.h"
#include "Trace/Surfaces/Curved/PieceKernels.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using Traits = NumberTraits<Lanes>;

/// Up to it a step that is held back lets a residual fall to 3/4 at least.
constexpr double kMostKappa = 0.35;
/// Up to it, in any norm, a piece has one root at most: where the first step stays in it, that is
/// looked for by so many steps before the piece is halved.
constexpr double kMostUnique = 0.8;
constexpr double kFewRounds = 6.0;
/// Of a pair whose residuals prove nothing.
constexpr double kNoKappa = 2.0;
constexpr double kMostRounds = 40.0;
/// After a step as small as this, Newton's iteration has arrived up to rounding.
constexpr double kArrived = 1e-8;
constexpr double kEdge = 1e-15;

/// The norm max w_i |x_i| of a matrix whose entries are not negative.
HWY_INLINE Lanes NormOf(const Lanes (&K)[3][3], const Lanes (&w)[3])
{
  Lanes largest = Splat(0.0);
  ForEachAxis([&](auto r) PIXELEXACT_INLINED
    { largest = Max(largest, w[r] * (K[r][0] / w[0] + K[r][1] / w[1] + K[r][2] / w[2])); });
  return largest;
}

/// A norm, max w_i |x_i|, in which ClampTo brings no two points farther from each other: the ends
/// of collapsed directions move with the xi that they are clamped after. Of two, the one in which K
/// is smaller; returns how large. A NaN in K gives no number, or an infinite one.
///
/// `unique` is how large K is in the best of some norms in which ClampTo need not do that.
HWY_INLINE Lanes ChooseNorm(Shape shape, const Lanes (&K)[3][3], Lanes (&w)[3], Lanes& unique)
{
  // x = 1.618...: 1/x + 1/x^2 = 1. The ends of a tetrahedron's eta_1 move with both other xi.
  constexpr double kGolden[3] = { 1.0, 1.6180339887498949, 2.6180339887498949 };
  const bool golden = shape == Shape::Tetrahedron;
  Lanes sum[3];
  Lanes largest = Splat(0.0);
  ForEachAxis(
    [&](auto r) PIXELEXACT_INLINED
    {
      w[r] = Splat(golden ? kGolden[r] : 1.0);
      sum[r] = K[r][0] + K[r][1] + K[r][2];
      largest = Max(largest, sum[r]);
    });
  // One in which its rows have about the same sum.
  const Lanes least = Splat(1e-2) * largest + Splat(0x1p-1000);
  Lanes v[3];
  ForEachAxis([&](auto r) PIXELEXACT_INLINED { v[r] = largest / Max(sum[r], least); });
  unique = Min(largest, NormOf(K, v));
  if (shape == Shape::Prism)
  {
    v[2] = Max(v[2], v[0]);
  }
  else if (shape == Shape::Pyramid)
  {
    v[2] = Max(v[2], Max(v[0], v[1]));
  }
  else if (golden)
  {
    // v_0 (1 / v_1 + 1 / v_2) <= 1, v_1 <= v_2.
    v[1] = Max(v[1], Splat(kGolden[1]) * v[0]);
    v[2] = Max(v[2], Max(v[1], Splat(kGolden[2]) * v[0]));
  }
  const Lanes usual = NormOf(K, w);
  const Lanes other = NormOf(K, v);
  const LaneMask better = other < usual;
  ForEachAxis([&](auto r) PIXELEXACT_INLINED { w[r] = Select(better, v[r], w[r]); });
  return Select(better, other, usual);
}

/// The point of a piece that is taken for a xi outside of it: along each direction of eta in turn,
/// from the last to the first, the nearest.
HWY_INLINE void ClampTo(Shape shape, const Lanes (&lower)[3], const Lanes (&upper)[3],
  const Lanes (&xi)[3], Lanes (&x)[3])
{
  const Lanes one = Splat(1.0);
  const Lanes half = Splat(0.5);
  const auto clampTo = [&](int d, Lanes extent) PIXELEXACT_INLINED
  { return Max(Min(xi[d], (one + upper[d]) * extent - one), (one + lower[d]) * extent - one); };
  x[2] = Max(Min(xi[2], upper[2]), lower[2]);
  const Lanes narrow = half * (one - x[2]);
  x[1] = clampTo(1, shape == Shape::Tetrahedron || shape == Shape::Pyramid ? narrow : one);
  x[0] = clampTo(0,
    shape == Shape::Hexahedron      ? one
      : shape == Shape::Tetrahedron ? half * (Splat(0.0) - x[1] - x[2])
                                    : narrow);
}

/// Not finite where there is none.
HWY_INLINE void InverseOf(const Lanes (&m)[3][3], Lanes (&inverse)[9])
{
  const auto minor = [&](int r0, int c0, int r1, int c1) PIXELEXACT_INLINED
  { return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]; };
  inverse[0] = minor(1, 1, 2, 2);
  inverse[1] = minor(0, 2, 2, 1);
  inverse[2] = minor(0, 1, 1, 2);
  inverse[3] = minor(1, 2, 2, 0);
  inverse[4] = minor(0, 0, 2, 2);
  inverse[5] = minor(0, 2, 1, 0);
  inverse[6] = minor(1, 0, 2, 1);
  inverse[7] = minor(0, 1, 2, 0);
  inverse[8] = minor(0, 0, 1, 1);
  const Lanes scale =
    Splat(1.0) / (m[0][0] * inverse[0] + m[0][1] * inverse[3] + m[0][2] * inverse[6]);
  for (Lanes& v : inverse)
  {
    v = v * scale;
  }
}

HWY_INLINE void Product(const Lanes (&m)[9], const Lanes (&v)[3], Lanes (&to)[3])
{
  ForEachAxis([&](auto r) PIXELEXACT_INLINED
    { to[r] = m[3 * r] * v[0] + m[3 * r + 1] * v[1] + m[3 * r + 2] * v[2]; });
}

HWY_INLINE Lanes Largest(const Lanes (&norm)[3], const Lanes (&v)[3])
{
  return Max(norm[0] * Abs(v[0]), Max(norm[1] * Abs(v[1]), norm[2] * Abs(v[2])));
}

/// test(i, mask) for each pack of rays of the set; returns those that passed.
template <class Test>
HWY_INLINE RaySet ForEachPack(const RaySet& rays, Test&& test)
{
  RaySet result;
  for (std::size_t word = 0; word < RaySet::kWords; ++word)
  {
    const std::uint64_t bits = rays.bits[word];
    result.bits[word] = ForEachPackIn(bits,
      [&](int i) PIXELEXACT_INLINED
      { return test(static_cast<int>(64 * word) + i, MaskOf(bits >> static_cast<unsigned>(i))); });
  }
  return result;
}

RaySet MeetBox(const RayBundle& bundle, const Box3& box, const RaySet& rays)
{
  const int axis = bundle.axes[2];
  const double lower = box.lower[axis] - bundle.z0;
  const double upper = box.upper[axis] - bundle.z0;
  const Lanes nearest = Splat(std::min(bundle.sign * lower, bundle.sign * upper));
  const Lanes farthest = Splat(std::max(bundle.sign * lower, bundle.sign * upper));
  return ForEachPack(rays,
    [&](int i, LaneMask /*mask*/) PIXELEXACT_INLINED
    {
      const auto load = [&](const RayBundle::Numbers& numbers) PIXELEXACT_INLINED
      { return Traits::Load(numbers.data() + i); };
      const Lanes slack = load(bundle.slack);
      LaneMask may =
        And(farthest + slack >= load(bundle.near), nearest - slack <= load(bundle.far));
      for (std::size_t a = 0; a < 2; ++a)
      {
        const Lanes place = load(bundle.place[a]);
        const Lanes slope = load(bundle.slope[a]);
        const Lanes p = place + slope * Splat(lower);
        const Lanes q = place + slope * Splat(upper);
        may = And(may,
          And(Min(p, q) - slack <= Splat(box.upper[bundle.axes[a]]),
            Max(p, q) + slack >= Splat(box.lower[bundle.axes[a]])));
      }
      return may;
    });
}

/// What a piece looks like to a ray, before its functions are evaluated.
RaySet Look(const RayBundle& bundle, const ElementFrame& frame, const CurvedPiece& piece,
  const RaySet& rays, PiecePairs& pairs)
{
  const std::size_t k = static_cast<std::size_t>(bundle.axes[2]);
  const Lanes along = Splat((bundle.z0 - frame.centre[bundle.axes[2]]) * frame.inverseSize);
  const Lanes zero = Splat(0.0);
  const double number = static_cast<double>(pairs.pieces.size());
  const int before = pairs.count;
  Lanes lower[3];
  Lanes upper[3];
  ForEachAxis(
    [&](auto d) PIXELEXACT_INLINED
    {
      lower[d] = Splat(piece.box.lower[d]);
      upper[d] = Splat(piece.box.upper[d]);
    });
  const auto look = [&](int i, LaneMask active) PIXELEXACT_INLINED
  {
    const auto load = [&](const RayBundle::Numbers& numbers) PIXELEXACT_INLINED
    { return Traits::Load(numbers.data() + i); };
    Lanes m[3][3];
    Lanes radius[3][3];
    Lanes g[3];
    Lanes error[3];
    Lanes slope[2];
    Lanes q[2];
    for (std::size_t a = 0; a < 2; ++a)
    {
      const auto c = static_cast<std::size_t>(bundle.axes[a]);
      const Lanes s = load(bundle.slope[a]);
      slope[a] = s;
      q[a] =
        (load(bundle.place[a]) - Splat(frame.centre[bundle.axes[a]])) * Splat(frame.inverseSize) -
        s * along;
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED
        {
          m[a][d] = Splat(piece.slope[c][d]) - s * Splat(piece.slope[k][d]);
          radius[a][d] = Splat(piece.radius[c][d]) + Abs(s) * Splat(piece.radius[k][d]);
        });
      g[a] = Splat(piece.value[c]) - s * Splat(piece.value[k]) - q[a];
      error[a] = Splat(piece.error[c] + piece.bend[c]) +
        Abs(s) * Splat(piece.error[k] + piece.bend[k]) +
        Splat(8.0 * kUnitRoundoff) * (Abs(q[a]) + Abs(along)) +
        load(bundle.slack) * Splat(frame.inverseSize);
    }
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        m[2][d] = Splat(piece.slope[3][d]);
        radius[2][d] = Splat(piece.radius[3][d]);
      });
    g[2] = Splat(piece.value[3]);
    error[2] = Splat(piece.error[3] + piece.bend[3]);
    Lanes inverse[9];
    InverseOf(m, inverse);
    Lanes first[3];
    Product(inverse, g, first);
    // NaNs neither miss nor decide.
    LaneMask misses = zero < zero;
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        const Lanes off = Abs(inverse[3 * r]) * error[0] + Abs(inverse[3 * r + 1]) * error[1] +
          Abs(inverse[3 * r + 2]) * error[2];
        // A root in the piece lies in centre - first +- off, however large that is.
        misses = Or(
          misses, (Splat(piece.half[r]) + off) * Splat(1.0 + 1e-9) + Splat(1e-14) < Abs(first[r]));
      });
    const LaneMask open = AndNot(active, misses);
    if (None(open))
    {
      return open;
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
    Lanes norm[3];
    Lanes unique;
    const Lanes kappa = ChooseNorm(frame.shape, K, norm, unique);
    // Max may lose a NaN, not so a sum.
    const Lanes all =
      K[0][0] + K[0][1] + K[0][2] + K[1][0] + K[1][1] + K[1][2] + K[2][0] + K[2][1] + K[2][2];
    Lanes start[3];
    Lanes xi[3];
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { start[d] = Splat(piece.centre[d]) - first[d]; });
    ClampTo(frame.shape, lower, upper, start, xi);
    LaneMask within = unique <= Splat(kMostUnique);
    ForEachAxis([&](auto d) PIXELEXACT_INLINED
      { within = And(within, Abs(start[d] - xi[d]) <= Splat(kEdge)); });
    const LaneMask contracts = kappa <= Splat(kMostKappa);
    const LaneMask pair = And(open, And(IsFinite(all), Or(contracts, within)));
    const LaneMask rest = AndNot(open, pair);
    if (None(pair))
    {
      return rest;
    }
    const auto put = [&](int column, Lanes value) PIXELEXACT_INLINED
    { Store(value, pairs.Column(column) + pairs.count); };
    put(kOpenColumn, Select(pair, Splat(1.0), zero));
    const hwy::HWY_NAMESPACE::RebindToSigned<LaneTag> whole;
    put(
      kRayColumn, { hwy::HWY_NAMESPACE::ConvertTo(LaneTag(), hwy::HWY_NAMESPACE::Iota(whole, i)) });
    put(kPieceColumn, Splat(number));
    for (int a = 0; a < 2; ++a)
    {
      put(kSlopeColumn + a, slope[a]);
      put(kPlaceColumn + a, q[a]);
    }
    for (int n = 0; n < 9; ++n)
    {
      put(kInverseColumn + n, inverse[n]);
    }
    put(kKappaColumn, Select(contracts, kappa, Splat(kNoKappa)));
    put(kLastColumn, zero);
    put(kRoundsColumn, Select(contracts, zero, Splat(kMostRounds - kFewRounds)));
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        put(kLowerColumn + d, lower[d]);
        put(kUpperColumn + d, upper[d]);
        put(kFaceColumn + d, Splat(piece.slope[3][d]));
        put(kXiColumn + d, xi[d]);
        put(kNormColumn + d, norm[d]);
      });
    pairs.count += LaneCount();
    return rest;
  };
  const RaySet unclear = ForEachPack(rays, look);
  if (pairs.count > before)
  {
    pairs.pieces.push_back(&piece);
  }
  return unclear;
}

/// A step of Newton's iteration with the slopes at xi where that stays in the piece, and with the
/// piece's own matrix where it has to be held back.
void Step(const RayBundle& bundle, const ElementFrame& frame, const double* values,
  std::size_t stride, PiecePairs& pairs, double* const position[3], double* result)
{
  const auto k = static_cast<std::size_t>(bundle.axes[2]);
  const Lanes zero = Splat(0.0);
  const auto number = [](PairResult one) { return Splat(static_cast<double>(one)); };
  for (int i = 0; i < pairs.count; i += LaneCount())
  {
    const auto load = [&](int column) PIXELEXACT_INLINED
    { return Traits::Load(pairs.Column(column) + i); };
    const auto value = [&](std::size_t n) PIXELEXACT_INLINED
    { return Traits::Load(values + n * stride + i); };
    const auto slopeAt = [&](std::size_t c, std::size_t d) PIXELEXACT_INLINED
    { return value(4 + 3 * c + d); };
    Lanes m[3][3];
    Lanes g[3];
    for (int a = 0; a < 2; ++a)
    {
      const auto c = static_cast<std::size_t>(bundle.axes[static_cast<std::size_t>(a)]);
      const Lanes s = load(kSlopeColumn + a);
      ForEachAxis([&](auto d) PIXELEXACT_INLINED { m[a][d] = slopeAt(c, d) - s * slopeAt(k, d); });
      g[a] = value(c) - s * value(k) - load(kPlaceColumn + a);
    }
    ForEachAxis([&](auto d) PIXELEXACT_INLINED
      { m[2][d] = frame.hasField ? slopeAt(3, d) : load(kFaceColumn + d); });
    g[2] = value(3);
    Lanes inverse[9];
    InverseOf(m, inverse);
    Lanes step[3];
    Product(inverse, g, step);
    Lanes xi[3];
    Lanes next[3];
    Lanes lower[3];
    Lanes upper[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        xi[d] = load(kXiColumn + d);
        next[d] = xi[d] - step[d];
        lower[d] = load(kLowerColumn + d);
        upper[d] = load(kUpperColumn + d);
      });
    Lanes inside[3];
    ClampTo(frame.shape, lower, upper, next, inside);
    Lanes over[3];
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { over[d] = next[d] - inside[d]; });
    const Lanes even[3] = { Splat(1.0), Splat(1.0), Splat(1.0) };
    const Lanes beyond = Largest(even, over);
    const LaneMask arrived = And(Largest(even, step) <= Splat(kArrived), beyond <= Splat(kEdge));
    const Lanes tolerance = Splat(frame.tolerance);
    const LaneMask there =
      And(Abs(g[0]) <= tolerance, And(Abs(g[1]) <= tolerance, Abs(g[2]) <= tolerance));
    const LaneMask hit = Or(arrived, there);
    for (int n = 0; n < 9; ++n)
    {
      inverse[n] = load(kInverseColumn + n);
    }
    Lanes frozen[3];
    Product(inverse, g, frozen);
    Lanes norm[3];
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { norm[d] = load(kNormColumn + d); });
    const Lanes residual = Largest(norm, frozen);
    // After a step with the piece's matrix, every root of the piece is nearer than kappa times what
    // it was before.
    const Lanes kappa = load(kKappaColumn);
    const Lanes last = load(kLastColumn);
    const Lanes falls = (Splat(1.0) + kappa) * kappa / (Splat(1.0) - kappa);
    // Both residuals are off by what g may be, by rounding and uncertainty, seen through the
    // matrix.
    Lanes off[3];
    ForEachAxis(
      [&](auto r) PIXELEXACT_INLINED
      {
        off[r] =
          tolerance * (Abs(inverse[3 * r]) + Abs(inverse[3 * r + 1]) + Abs(inverse[3 * r + 2])) +
          Splat(kEdge);
      });
    const LaneMask contracts = kappa < Splat(1.0);
    const LaneMask miss = And(contracts,
      And(zero < last,
        falls * last * Splat(1.0 + 1e-6) + Splat(2.0) * Largest(norm, off) < residual));
    const Lanes rounds = load(kRoundsColumn) + Splat(1.0);
    const LaneMask stays = beyond <= zero;
    const LaneMask goesOn =
      And(And(IsFinite(residual), rounds <= Splat(kMostRounds)), Or(contracts, stays));
    const LaneMask free = AndNot(stays, And(contracts, rounds >= Splat(0.5 * kMostRounds)));
    Lanes back[3];
    Lanes held[3];
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { back[d] = xi[d] - frozen[d]; });
    ClampTo(frame.shape, lower, upper, back, held);
    Lanes end = Select(goesOn, number(PairResult::Again), number(PairResult::Unclear));
    end = Select(miss, number(PairResult::Miss), end);
    end = Select(hit, number(PairResult::Hit), end);
    Store(end, result + i);
    Store(Select(free, zero, residual), pairs.Column(kLastColumn) + i);
    Store(rounds, pairs.Column(kRoundsColumn) + i);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const Lanes moved = Select(free, inside[d], held[d]);
        const Lanes found = Select(arrived, inside[d], xi[d]);
        Store(Select(hit, found, moved), pairs.Column(kXiColumn + d) + i);
        const auto c = static_cast<std::size_t>(d);
        const Lanes last3 =
          slopeAt(c, 0) * step[0] + slopeAt(c, 1) * step[1] + slopeAt(c, 2) * step[2];
        const Lanes y = value(c) - Select(arrived, last3, zero);
        Store(Splat(frame.centre[d]) + Splat(frame.size) * y, position[d] + i);
      });
  }
}

const PieceKernels& Table()
{
  static const PieceKernels kTable{ MeetBox, Look, Step };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(Table);

const PieceKernels& GetPieceKernels()
{
  return HWY_DYNAMIC_DISPATCH(Table)();
}
} // namespace pixelexact
#endif
