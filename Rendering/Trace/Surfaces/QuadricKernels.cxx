// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/QuadricKernels.cxx"
#include <hwy/foreach_target.h>

#include "Trace/Surfaces/PairRay-inl.h"
#include "Trace/Surfaces/SurfaceKernels.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The roots of A s^2 + 2 B s + C in order; roots that are not finite do not count.
struct TwoRoots
{
  Pair first;
  Pair second;
  LaneMask any;
  LaneMask two;
};

/// B^2 - A C
HWY_INLINE Pair Discriminant(const Pair& A, const Pair& B, const Pair& C)
{
  const Pair square = Term(B, B);
  const Pair product = Term(A, C);
  const Pair difference = ExactSum(square.high, Splat(0.0) - product.high);
  return FastSum(difference.high, difference.low + (square.low - product.low));
}

/// Slots 0 and 1, requested at the first hit.
class TwoSlots
{
public:
  HWY_INLINE TwoSlots(const RayLanes& rays, HitSlots& hits)
    : Rays(rays)
    , Hits(hits)
  {
  }

  HWY_INLINE void Put(const PairRay& ray, const Lanes (&centre)[3], const TwoRoots& roots, int at)
  {
    const Lanes t1 = ray.TimeAt(roots.first);
    const Lanes unordered = ray.TimeAt(roots.second);
    // Rounding may reverse the order of two roots that nearly coincide.
    const Lanes t2 = Select(unordered < t1, t1, unordered);
    const LaneMask any = And(roots.any, RaysOfPack(at, Rays.count));
    const LaneMask in1 = And(any, WithinEnds(Rays, at, t1));
    const LaneMask in2 = And(And(any, roots.two), WithinEnds(Rays, at, t2));
    if (None(Or(in1, in2)))
    {
      return;
    }
    Pair middle[3];
    ray.Middle(centre, middle);
    const Lanes none = Splat(kNoHit);
    const HitLanes& slot = SlotOf(0);
    Store(Select(in1, t1, Select(in2, t2, none)), slot.t + at);
    const Pair s{ Select(in1, roots.first.high, roots.second.high),
      Select(in1, roots.first.low, roots.second.low) };
    ray.PutPosition(middle, s, slot.position, at);
    const LaneMask both = And(in1, in2);
    if (!None(both))
    {
      const HitLanes& next = SlotOf(1);
      Store(Select(both, t2, none), next.t + at);
      ray.PutPosition(middle, roots.second, next.position, at);
    }
  }

private:
  HWY_INLINE const HitLanes& SlotOf(int k)
  {
    for (; Count <= k; ++Count)
    {
      Slots[Count] = Hits.Slot(Count);
    }
    return Slots[k];
  }

  const RayLanes& Rays;
  HitSlots& Hits;
  HitLanes Slots[2];
  int Count = 0;
};

/// A pack of rays in doubles, from their origins, to skip rays that are proven to miss. The error
/// of each discriminant is some dozen roundings of the sum of its terms' magnitudes. A discriminant
/// below -2^-46 of this sum proves a miss. A NaN does not.
struct PlainRay
{
  Lanes y[3];
  Lanes d[3];
  Lanes yy;
  Lanes yd;

  HWY_INLINE PlainRay(const RayLanes& rays, int at, const Lanes (&centre)[3])
  {
    using Traits = NumberTraits<Lanes>;
    ForEachAxis(
      [&](auto i) PIXELEXACT_INLINED
      {
        y[i] = Traits::Load(rays.origin[i] + at) - centre[i];
        d[i] = Traits::Load(rays.direction[i] + at);
      });
    yy = PlainDot(y, y);
    yd = PlainDot(y, d);
  }

  /// A ray of the pack may meet the surface. The discriminant's error is `perSquare` |y|^2 +
  /// `rest`.
  [[nodiscard]] HWY_INLINE bool MayMeet(
    const RayLanes& rays, int at, Lanes discriminant, double perSquare, double rest) const
  {
    const LaneMask misses = discriminant < Splat(-rest) - Splat(perSquare) * yy;
    return !None(AndNot(RaysOfPack(at, rays.count), misses));
  }
};

void MeetSphere(
  const Vec3& centre, const DoublePair& squaredRadius, const RayLanes& rays, HitSlots& hits)
{
  const Lanes c[3] = { Splat(centre.x), Splat(centre.y), Splat(centre.z) };
  const Pair minusSquare = Negative(Pair::Of(squaredRadius));
  const double perSquare = 0x1p-45;
  const double rest = 0x1p-46 * squaredRadius.high;
  const Lanes zero = Splat(0.0);
  TwoSlots slots(rays, hits);
  for (int i = 0; i < rays.count; i += LaneCount())
  {
    const PlainRay plain(rays, i, c);
    if (!plain.MayMeet(
          rays, i, plain.yd * plain.yd - (plain.yy + minusSquare.high), perSquare, rest))
    {
      continue;
    }
    const PairRay ray(rays, i, c, zero - plain.yd);
    const Pair& A = ray.squaredLength;
    PairSum sum = SumOfTerms(ray.p, ray.p);
    sum.Add(minusSquare);
    const Pair C = sum.Get();
    // p is closest to the centre, so B has the size of t0's rounding. The rounding of B and B^2,
    // and the loss of FastSum where B is not the smaller one, have the size of p's rounding.
    const PairSum product = SumOfTerms(ray.p, ray.d);
    const Lanes minusB = zero - (product.high + product.low);
    const Pair AC = Term(A, C);
    const Pair difference = FastSum(zero - AC.high, minusB * minusB);
    const Pair D = FastSum(difference.high, difference.low - AC.low);
    const LaneMask any = D.high >= zero;
    if (None(any))
    {
      continue;
    }
    const Pair root = SquareRoot(D);
    const Pair below = FastSum(zero - root.high, minusB);
    const Pair above = FastSum(root.high, minusB);
    const Lanes reciprocal = Splat(1.0) / A.high;
    slots.Put(ray, c,
      { Over({ below.high, below.low - root.low }, A, reciprocal),
        Over({ above.high, above.low + root.low }, A, reciprocal), any, zero < D.high },
      i);
  }
}

/// Uses the sum that does not cancel, so that a root stays accurate if A vanishes.
HWY_INLINE TwoRoots RootsOf(const Pair& A, const Pair& B, const Pair& C, const Pair& D)
{
  const Lanes zero = Splat(0.0);
  const Lanes one = Splat(1.0);
  const LaneMask negative = B.high < zero;
  const Pair root = SquareRoot(D);
  const Pair minusRoot = Negative(root);
  const Pair minusB = Negative(B);
  const Pair q = Plus(minusB,
    { Select(negative, root.high, minusRoot.high), Select(negative, root.low, minusRoot.low) });
  const Pair a = Over(q, A, one / A.high);
  const Pair b = Over(C, q, one / q.high);
  const LaneMask twice = D.high <= zero;
  const LaneMask bFirst = AndNot(b.high < a.high, twice);
  const auto pick = [](LaneMask mask, const Pair& yes, const Pair& no) PIXELEXACT_INLINED {
    return Pair{ Select(mask, yes.high, no.high), Select(mask, yes.low, no.low) };
  };
  return { pick(bFirst, b, a), pick(bFirst, a, b), D.high >= zero, zero < D.high };
}

void MeetRound(const AxisForm& form, const RayLanes& rays, HitSlots& hits)
{
  const Lanes c[3] = { Splat(form.centre.x), Splat(form.centre.y), Splat(form.centre.z) };
  const Pair v[3] = { Pair::Of(form.v[0]), Pair::Of(form.v[1]), Pair::Of(form.v[2]) };
  const Lanes plainV[3] = { v[0].high, v[1].high, v[2].high };
  const Pair k = Pair::Of(form.k);
  // |A|, |B| and |C| are at most `size`, size |y| and size |y|^2 - k.
  const double size = 1.0 + form.v[0].high * form.v[0].high + form.v[1].high * form.v[1].high +
    form.v[2].high * form.v[2].high;
  const double perSquare = 0x1p-45 * (size * size);
  const double rest = -0x1p-46 * (size * form.k.high);
  TwoSlots slots(rays, hits);
  for (int i = 0; i < rays.count; i += LaneCount())
  {
    const PlainRay plain(rays, i, c);
    {
      const Lanes vd = PlainDot(plainV, plain.d);
      const Lanes vy = PlainDot(plainV, plain.y);
      const Lanes B = plain.yd - vy * vd;
      const Lanes AC = (Splat(1.0) - vd * vd) * ((plain.yy - vy * vy) + k.high);
      if (!plain.MayMeet(rays, i, B * B - AC, perSquare, rest))
      {
        continue;
      }
    }
    const PairRay ray(rays, i, c, Splat(0.0) - plain.yd);
    const Pair vd = PairDot(v, ray.d);
    const Pair vp = PairDot(v, ray.p);
    PairSum A{ ray.squaredLength.high, ray.squaredLength.low };
    A.Add(Negative(Term(vd, vd)));
    PairSum B = SumOfTerms(ray.p, ray.d);
    B.Add(Negative(Term(vp, vd)));
    PairSum C = SumOfTerms(ray.p, ray.p);
    C.Add(Negative(Term(vp, vp)));
    C.Add(k);
    const Pair D = Discriminant(A.Get(), B.Get(), C.Get());
    if (!None(D.high >= Splat(0.0)))
    {
      slots.Put(ray, c, RootsOf(A.Get(), B.Get(), C.Get(), D), i);
    }
  }
}

template <bool kCentred>
HWY_INLINE void Meet(const QuadraticForm& form, const RayLanes& rays, HitSlots& hits)
{
  const Lanes c[3] = { Splat(form.centre.x), Splat(form.centre.y), Splat(form.centre.z) };
  Pair Q[6];
  for (int i = 0; i < 6; ++i)
  {
    Q[i] = Pair::Of(form.Q[i]);
  }
  const Pair rows[3][3] = { { Q[0], Q[3], Q[5] }, { Q[3], Q[1], Q[4] }, { Q[5], Q[4], Q[2] } };
  const Pair b[3] = { Pair::Of(form.b[0]), Pair::Of(form.b[1]), Pair::Of(form.b[2]) };
  const Pair k = Pair::Of(form.k);
  const Lanes zero = Splat(0.0);
  // |A|, |B| and |C| are at most q, q |y| + l and q |y|^2 + 2 l |y| + |k|.
  const auto size = [](const DoublePair& number) { return std::fabs(number.high); };
  const double q = size(form.Q[0]) + size(form.Q[1]) + size(form.Q[2]) +
    2.0 * (size(form.Q[3]) + size(form.Q[4]) + size(form.Q[5]));
  const double l = size(form.b[0]) + size(form.b[1]) + size(form.b[2]);
  const double perSquare = 0x1p-44 * (q * q);
  const double rest = 0x1p-44 * (l * l + q * size(form.k));
  TwoSlots slots(rays, hits);
  for (int i = 0; i < rays.count; i += LaneCount())
  {
    const PlainRay plain(rays, i, c);
    {
      Lanes Qd[3];
      Lanes half[3];
      ForEachAxis(
        [&](auto j) PIXELEXACT_INLINED
        {
          const Lanes row[3] = { rows[j][0].high, rows[j][1].high, rows[j][2].high };
          Qd[j] = PlainDot(row, plain.d);
          half[j] = PlainDot(row, plain.y);
        });
      const Lanes A = PlainDot(Qd, plain.d);
      Lanes B = PlainDot(Qd, plain.y);
      Lanes C = PlainDot(half, plain.y) + k.high;
      if constexpr (!kCentred)
      {
        const Lanes linear[3] = { b[0].high, b[1].high, b[2].high };
        B = B + PlainDot(linear, plain.d);
        C = C + Splat(2.0) * PlainDot(linear, plain.y);
      }
      if (!plain.MayMeet(rays, i, B * B - A * C, perSquare, rest))
      {
        continue;
      }
    }
    const PairRay ray(rays, i, c, zero - plain.yd);
    const Pair Qd[3] = { PairDot(rows[0], ray.d), PairDot(rows[1], ray.d),
      PairDot(rows[2], ray.d) };
    const Pair A = PairDot(Qd, ray.d);
    Pair B;
    Pair half[3]; // Q p + 2 b
    if constexpr (kCentred)
    {
      B = PairDot(Qd, ray.p);
      ForEachAxis([&](auto j) PIXELEXACT_INLINED { half[j] = PairDot(rows[j], ray.p); });
    }
    else
    {
      B = Plus(PairDot(Qd, ray.p), PairDot(b, ray.d));
      ForEachAxis(
        [&](auto j) PIXELEXACT_INLINED
        {
          PairSum sum = SumOfTerms(rows[j], ray.p);
          sum.Add({ b[j].high + b[j].high, b[j].low + b[j].low });
          half[j] = sum.Get();
        });
    }
    PairSum sum = SumOfTerms(half, ray.p);
    sum.Add(k);
    const Pair C = sum.Get();
    const Pair D = Discriminant(A, B, C);
    if (!None(D.high >= zero))
    {
      slots.Put(ray, c, RootsOf(A, B, C, D), i);
    }
  }
}

void MeetQuadric(const QuadraticForm& form, const RayLanes& rays, HitSlots& hits)
{
  Meet<false>(form, rays, hits);
}

void MeetCentred(const QuadraticForm& form, const RayLanes& rays, HitSlots& hits)
{
  Meet<true>(form, rays, hits);
}

const QuadricKernels& QuadricKernelSet()
{
  static constexpr QuadricKernels kKernels{ &MeetSphere, &MeetRound, &MeetQuadric, &MeetCentred };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(QuadricKernelSet);

const QuadricKernels& GetQuadricKernels()
{
  return HWY_DYNAMIC_DISPATCH(QuadricKernelSet)();
}
} // namespace pixelexact
#endif
