// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/TorusKernels.cxx"
#include <hwy/foreach_target.h>

#include "Trace/Surfaces/SurfaceKernels.h"
#include "Trace/Surfaces/TorusQuartic-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// Up to four slots, requested when a hit needs them.
class FourSlots
{
public:
  explicit FourSlots(HitSlots& hits)
    : Hits(hits)
  {
  }
  HWY_INLINE const HitLanes& operator[](int k)
  {
    for (; Count <= k; ++Count)
    {
      Slots[Count] = Hits.Slot(Count);
    }
    return Slots[k];
  }
  HitStatus* Status(int k) { return Hits.Status(k); }

private:
  HitSlots& Hits;
  HitLanes Slots[4];
  int Count = 0;
};

/// Puts a pack's hits into its rays' slots, candidate by candidate in order of t.
class PackHits
{
public:
  HWY_INLINE PackHits(const TorusForm& form, const PairRay& ray, const Lanes (&centre)[3],
    const RayLanes& rays, int at, FourSlots& slots)
    : Ray(ray)
    , Rays(rays)
    , Slots(slots)
    , At(at)
    , Size(1.0 / form.unit)
    , Number(Splat(0.0))
    , Last(NumberTraits<Lanes>::Load(rays.tNear + at))
  {
    ray.Middle(centre, Middle);
  }

  /// Adds a hit at s, in the form's units.
  HWY_INLINE void Add(const Pair& units, LaneMask certain, LaneMask undecided)
  {
    const Pair s{ units.high * Splat(Size), units.low * Splat(Size) };
    const Lanes t = Ray.TimeAt(s);
    const LaneMask hit = And(Or(certain, undecided), WithinEnds(Rays, At, t));
    if (None(hit))
    {
      return;
    }
    // Rounding may reverse the order of two roots that nearly coincide.
    Last = Select(hit, Max(Last, t), Last);
    Lanes position[3];
    Ray.PositionAt(Middle, s, position);
    LaneMask left = hit;
    for (int k = 0; !None(left); ++k)
    {
      const LaneMask here = And(left, Number <= Splat(k));
      left = AndNot(left, here);
      if (!None(here))
      {
        PutInSlot(k, here, undecided, position);
      }
    }
    Number = Select(hit, Number + Splat(1.0), Number);
  }

private:
  HWY_INLINE void PutInSlot(int k, LaneMask here, LaneMask undecided, const Lanes (&position)[3])
  {
    using Traits = NumberTraits<Lanes>;
    const HitLanes& slot = Slots[k];
    Store(Select(here, Last, Traits::Load(slot.t + At)), slot.t + At);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        double* const to = slot.position[d] + At;
        Store(Select(here, position[d], Traits::Load(to)), to);
      });
    for (std::uint64_t bits = BitsOf(And(here, undecided)); bits != 0; bits &= bits - 1)
    {
      Slots.Status(k)[At + std::countr_zero(bits)] = HitStatus::Undecided;
    }
  }

  const PairRay& Ray;
  const RayLanes& Rays;
  FourSlots& Slots;
  const int At;
  const double Size;
  Pair Middle[3];
  Lanes Number; ///< of hits so far
  Lanes Last;
};

/// Adds hits by the signs of f in pairs of doubles.
HWY_NOINLINE void AddCarefully(const RayQuartic& quartic, LaneMask wanted, PackHits& found)
{
  const Pair(&f)[5] = quartic.f;
  const Pair slope[4] = { f[1], Scaled(f[2], 2.0), Times(f[3], Pair::Of(Splat(3.0))),
    Scaled(f[4], 4.0) };
  const Lanes zero = Splat(0.0);
  Lanes ends[4];
  {
    Lanes extrema[3];
    Extrema(quartic, slope, wanted, extrema);
    ends[0] = extrema[0];
    ends[1] = extrema[1];
    ends[2] = extrema[2];
    ends[3] = quartic.end;
  }
  // Visits the intervals in order. A change of sign is a hit between the two ends. If an undecided
  // sign lies between equal signs, there may be a hit at that end.
  Lanes last = zero - quartic.end;
  LaneMask wasInside = zero < zero;
  LaneMask touches = zero < zero;
  Lanes touched = zero;
  for (const Lanes end : ends)
  {
    const Lanes value = Horner(f, end).high;
    const LaneMask isKnown = quartic.noise < Abs(value);
    const LaneMask isInside = value < zero;
    const LaneMask isOther = Or(AndNot(wasInside, isInside), AndNot(isInside, wasInside));
    const LaneMask crosses = And(wanted, And(isKnown, isOther));
    const LaneMask touch = And(wanted, AndNot(And(isKnown, touches), isOther));
    if (!None(Or(crosses, touch)))
    {
      const Lanes root = None(crosses) ? touched : SignChange(f, last, end, wasInside, crosses);
      const Pair s = Polished(f, root, last, end);
      found.Add({ Select(touch, touched, s.high), Select(touch, zero, s.low) }, crosses, touch);
    }
    const LaneMask unknown = AndNot(wanted, isKnown);
    touched = Select(AndNot(unknown, touches), end, touched);
    touches = unknown;
    last = Select(isKnown, end, last);
    wasInside = Or(And(isKnown, isInside), AndNot(wasInside, isKnown));
  }
}

void MeetTorus(const TorusForm& form, const RayLanes& rays, HitSlots& hits)
{
  using Traits = NumberTraits<Lanes>;
  const Lanes c[3] = { Splat(form.centre.x), Splat(form.centre.y), Splat(form.centre.z) };
  const Lanes v[3] = { Splat(form.axis[0].high), Splat(form.axis[1].high),
    Splat(form.axis[2].high) };
  const Lanes zero = Splat(0.0);
  const Lanes unit = Splat(form.unit);
  const Lanes end = Splat(1.001 * form.reach);
  FourSlots slots(hits);
  for (int i = 0; i < rays.count; i += LaneCount())
  {
    Lanes d[3];
    Lanes y[3];
    ForEachAxis(
      [&](auto j) PIXELEXACT_INLINED
      {
        d[j] = Traits::Load(rays.direction[j] + i);
        y[j] = Traits::Load(rays.origin[j] + i) - c[j];
      });
    const auto dot = [](const Lanes(&a)[3], const Lanes(&b)[3]) PIXELEXACT_INLINED
    { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const Lanes t0 = zero - dot(y, d);
    ForEachAxis([&](auto j) PIXELEXACT_INLINED { y[j] = (y[j] + t0 * d[j]) * unit; });
    const Lanes yy = dot(y, y);
    const Lanes error = Splat(0x1p-42) * (Splat(1.0) + Abs(t0) * unit);
    const LaneMask wanted =
      And(RaysOfPack(i, rays.count), yy <= Splat(form.reach * form.reach) + error);
    if (None(wanted))
    {
      continue;
    }
    const Lanes yv = dot(y, v);
    const Lanes dv = dot(d, v);
    const LaneMask near = And(wanted, Abs(yv) <= Splat(form.slab) + error + Abs(dv) * end);
    const Lanes rim = yy - Splat(form.sum.high);
    const Lanes g2 = (rim + rim) + dv * dv;
    const Lanes g1 = Splat(2.0) * (yv * dv);
    const Lanes g0 = rim * rim + yv * yv - Splat(form.product.high);
    const RoughQuartic rough(g2, g1, g0, error, end);
    const LaneMask below[3] = { rough.at[0] < zero, rough.at[1] < zero, rough.at[2] < zero };
    LaneMask doubtful = AndNot(near, rough.certain);
    LaneMask met = And(And(near, rough.certain), Or(Or(below[0], below[1]), below[2]));
    if (None(Or(met, doubtful)))
    {
      continue;
    }
    const PairRay ray(rays, i, c, t0);
    const RayQuartic quartic = QuarticOf(form, ray);
    PackHits found(form, ray, c, rays, i, slots);
    if (!None(met))
    {
      const Lanes(&e)[3] = rough.extrema;
      const Lanes(&at)[3] = rough.at;
      const LaneMask inner = And(met, AndNot(And(below[0], below[2]), below[1]));
      const bool hasInner = !None(inner);
      const auto pick = [](LaneMask first, LaneMask second, Lanes a, Lanes b, Lanes rest)
                          PIXELEXACT_INLINED { return Select(first, a, Select(second, b, rest)); };
      const Lanes lowest = pick(below[0], below[1], e[0], e[1], e[2]);
      const Lanes highest = pick(below[2], below[1], e[2], e[1], e[0]);
      LaneMask failed = zero < zero;
      Pair s[4] = { Pair::Of(zero), Pair::Of(zero), Pair::Of(zero), Pair::Of(zero) };
      s[0] = RootIn(quartic.f,
        { pick(below[0], below[1], zero - end, e[0], e[1]), lowest, lowest,
          pick(below[0], below[1], at[0], at[1], at[2]) },
        false, met, failed);
      if (hasInner)
      {
        s[1] = RootIn(quartic.f, { e[0], e[1], e[0], at[0] }, true, inner, failed);
        s[2] = RootIn(quartic.f, { e[1], e[2], e[2], at[2] }, false, inner, failed);
      }
      s[3] = RootIn(quartic.f,
        { highest, pick(below[2], below[1], end, e[2], e[1]), highest,
          pick(below[2], below[1], at[2], at[1], at[0]) },
        true, met, failed);
      doubtful = Or(doubtful, failed);
      met = AndNot(met, failed);
      const LaneMask no = zero < zero;
      found.Add(s[0], met, no);
      if (hasInner)
      {
        found.Add(s[1], AndNot(inner, failed), no);
        found.Add(s[2], AndNot(inner, failed), no);
      }
      found.Add(s[3], met, no);
    }
    if (!None(doubtful))
    {
      AddCarefully(quartic, And(doubtful, quartic.isNear), found);
    }
  }
}

const TorusKernels& TorusKernelSet()
{
  static constexpr TorusKernels kKernels{ &MeetTorus };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(TorusKernelSet);

const TorusKernels& GetTorusKernels()
{
  return HWY_DYNAMIC_DISPATCH(TorusKernelSet)();
}
} // namespace pixelexact
#endif
