// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/RayKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Element/Matrix-inl.h"
#include "Trace/RayKernels.h"
#include "Trace/Surface.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
// Sums and products are rounded one by one, as the scalar ones of Camera::At are.
HWY_INLINE Lanes Dot(const Point<Lanes>& a, const Point<Lanes>& b)
{
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

HWY_INLINE Point<Lanes> SplatPoint(const Vec3& x)
{
  return { { Splat(x.x), Splat(x.y), Splat(x.z) } };
}

HWY_INLINE Point<Lanes> At(const CameraRays::Linear& linear, Lanes u, Lanes v)
{
  Point<Lanes> x;
  for (int d = 0; d < 3; ++d)
  {
    x.x[d] = Splat(linear.constant[d]) + Splat(linear.u[d]) * u + Splat(linear.v[d]) * v;
  }
  return x;
}

void CastRays(const CameraRays& camera, const double* u, const double* v, int count,
  double* const origin[3], double* const direction[3])
{
  using Traits = NumberTraits<Lanes>;
  const bool parallel = camera.direction.u == Vec3(0.0) && camera.direction.v == Vec3(0.0);
  const Point<Lanes> along = SplatPoint(camera.direction.constant);
  const Lanes reciprocal = Splat(1.0) / Sqrt(Dot(along, along));
  for (int i = 0; i < count; i += LaneCount())
  {
    const Lanes atU = Traits::Load(u + i);
    const Lanes atV = Traits::Load(v + i);
    const Point<Lanes> from = At(camera.origin, atU, atV);
    Point<Lanes> to = along;
    Lanes scale = reciprocal;
    if (!parallel)
    {
      to = At(camera.direction, atU, atV);
      scale = Splat(1.0) / Sqrt(Dot(to, to));
    }
    for (int d = 0; d < 3; ++d)
    {
      Store(from.x[d], origin[d] + i);
      Store(to.x[d] * scale, direction[d] + i);
    }
  }
}

void MeetPlane(const Vec3& origin, const Vec3& normal, const RayLanes& rays, const double* tMin,
  const HitLanes& hits)
{
  using Traits = NumberTraits<Lanes>;
  const Point<Lanes> through = SplatPoint(origin);
  const Point<Lanes> across = SplatPoint(normal);
  for (int i = 0; i < rays.count; i += LaneCount())
  {
    Point<Lanes> from;
    Point<Lanes> to;
    Point<Lanes> distance;
    for (int d = 0; d < 3; ++d)
    {
      from.x[d] = Traits::Load(rays.origin[d] + i);
      to.x[d] = Traits::Load(rays.direction[d] + i);
      distance.x[d] = through.x[d] - from.x[d];
    }
    const Lanes t = Dot(across, distance) / Dot(across, to);
    // A slope of zero makes t infinite or NaN: no hit either way.
    const LaneMask hit = And(Traits::Load(tMin + i) < t, IsFinite(t));
    Point<Lanes> x;
    Point<Lanes> off;
    for (int d = 0; d < 3; ++d)
    {
      x.x[d] = from.x[d] + t * to.x[d];
      off.x[d] = x.x[d] - through.x[d];
    }
    // From a far origin the rounding of t moves x off the plane; put it back along the normal.
    const Lanes height = Dot(across, off);
    Store(Select(hit, t, Splat(kNoHit)), hits.t + i);
    for (int d = 0; d < 3; ++d)
    {
      Store(x.x[d] - across.x[d] * height, hits.position[d] + i);
    }
  }
}

const RayKernels& RayKernelSet()
{
  static constexpr RayKernels kKernels{ &CastRays, &MeetPlane };
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
