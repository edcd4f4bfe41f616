// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/RayKernels.cxx"
#include <hwy/foreach_target.h>

#include "Trace/LanePoint-inl.h"
#include "Trace/RayKernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// The arrays of three coordinates, by value, so that stores do not alias them.
struct PointTarget
{
  double* x[3];

  explicit HWY_INLINE PointTarget(double* const to[3])
    : x{ to[0], to[1], to[2] }
  {
  }
  HWY_INLINE void Put(const LanePoint& point, int at) const
  {
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { Store(point.x[d], x[d] + at); });
  }
};

void CastRays(const CameraRays& camera, const double* u, const double* v, int count,
  double* const origin[3], double* const direction[3])
{
  using Traits = NumberTraits<Lanes>;
  const bool parallel = camera.direction.u == Vec3(0.0) && camera.direction.v == Vec3(0.0);
  const LinearLanes origins(camera.origin);
  const LinearLanes directions(camera.direction);
  const PointTarget toOrigin(origin);
  const PointTarget toDirection(direction);
  const LanePoint along = Normalized(directions.constant);
  for (int i = 0; i < count; i += LaneCount())
  {
    const Lanes atU = Traits::Load(u + i);
    const Lanes atV = Traits::Load(v + i);
    toOrigin.Put(origins.At(atU, atV), i);
    toDirection.Put(parallel ? along : Normalized(directions.At(atU, atV)), i);
  }
}

/// Relative to t; covers rounding amply.
constexpr double kClipMargin = 1e-12;

void ClipToBox(const Box3& box, const double* const origin[3], const double* const direction[3],
  int count, double* near, double* far)
{
  using Traits = NumberTraits<Lanes>;
  const LanePoint lower = SplatPoint(box.lower);
  const LanePoint upper = SplatPoint(box.upper);
  const LanePoints origins{ { origin[0], origin[1], origin[2] }, count };
  const LanePoints directions{ { direction[0], direction[1], direction[2] }, count };
  // These quotients are off by less than 4 roundings. But a surface in doubles may place its point
  // some roundings of the ray's origin away from t, which is more if the origin is far away.
  const Lanes less = Splat(1.0 - kClipMargin);
  const Lanes more = Splat(1.0 + kClipMargin);
  for (int i = 0; i < count; i += LaneCount())
  {
    const auto from = LoadPoint<Lanes>(origins, i);
    const auto to = LoadPoint<Lanes>(directions, i);
    Lanes first = Traits::Load(near + i);
    Lanes last = Traits::Load(far + i);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        const Lanes scale = Splat(1.0) / to.x[d];
        const Lanes a = (lower.x[d] - from.x[d]) * scale;
        const Lanes b = (upper.x[d] - from.x[d]) * scale;
        const LaneMask rises = a < b;
        const Lanes enters = Select(rises, a, b);
        const Lanes leaves = Select(rises, b, a);
        // A ray inside a face's plane gives NaN, and that plane does not clip it.
        const Lanes widerFirst = Select(enters < Splat(0.0), enters, enters * less);
        const Lanes widerLast = Select(leaves < Splat(0.0), leaves * less, leaves * more);
        first = Select(first < widerFirst, widerFirst, first);
        last = Select(widerLast < last, widerLast, last);
      });
    Store(first, near + i);
    Store(last, far + i);
  }
}

void MeetPlane(const Vec3& origin, const Vec3& normal, const RayLanes& rays, const HitLanes& hits)
{
  using Traits = NumberTraits<Lanes>;
  const LanePoint through = SplatPoint(origin);
  const LanePoint across = SplatPoint(normal);
  const LanePoints origins{ { rays.origin[0], rays.origin[1], rays.origin[2] }, rays.count };
  const LanePoints directions{ { rays.direction[0], rays.direction[1], rays.direction[2] },
    rays.count };
  const PointTarget position(hits.position);
  double* const toT = hits.t;
  for (int i = 0; i < rays.count; i += LaneCount())
  {
    const auto from = LoadPoint<Lanes>(origins, i);
    const auto to = LoadPoint<Lanes>(directions, i);
    const Lanes t = Dot(across, through - from) / Dot(across, to);
    // A slope of zero makes t infinite or NaN. Neither is a hit, because the interval ends at a
    // finite t.
    const LaneMask hit = And(Traits::Load(rays.tNear + i) <= t, t <= Traits::Load(rays.tFar + i));
    const LanePoint x = from + to * t;
    // With a far origin, the rounding of t moves x off the plane; x is moved back along the normal.
    const Lanes height = Dot(across, x - through);
    Store(Select(hit, t, Splat(kNoHit)), toT + i);
    position.Put(x - across * height, i);
  }
}

int CountHits(const double* t, int count)
{
  int hits = 0;
  for (int i = 0; i < count; i += LaneCount())
  {
    std::uint64_t bits = BitsOf(NumberTraits<Lanes>::Load(t + i) < Splat(kNoHit));
    if (count - i < LaneCount())
    {
      bits &= (std::uint64_t{ 1 } << static_cast<unsigned>(count - i)) - 1U;
    }
    hits += std::popcount(bits);
  }
  return hits;
}

bool AreFinite(const double* values, int count)
{
  const int lanes = LaneCount();
  LaneMask finite = Splat(0.0) <= Splat(0.0);
  int i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    finite = And(finite, IsFinite(NumberTraits<Lanes>::Load(values + i)));
  }
  return All(finite) &&
    std::all_of(values + i, values + count, [](double v) { return std::isfinite(v); });
}

const RayKernels& RayKernelSet()
{
  static constexpr RayKernels kKernels{ &CastRays, &ClipToBox, &MeetPlane, &CountHits, &AreFinite };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(RayKernelSet);

const RayKernels& GetRayKernels()
{
  return HWY_DYNAMIC_DISPATCH(RayKernelSet)();
}
} // namespace pixelexact
#endif
