// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/TriangleKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Math/Pair-inl.h"
#include "Trace/LanePoint-inl.h"
#include "Trace/Surfaces/Curved/GatheredRays-inl.h"
#include "Trace/Surfaces/TriangleKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// p.x q.y - p.y q.x: twice the area over the edge, whose sign is right, and which is 0 only where
/// it is 0; changes its sign, to the bit, where p and q change their places.
HWY_INLINE Lanes Across(const Lanes (&p)[2], const Lanes (&q)[2])
{
  const Pair a = ExactProduct(p[0], q[1]);
  const Pair b = ExactProduct(p[1], q[0]);
  // Exact where the products are close; where they are not, their rounding errors do not count.
  return (a.high - b.high) + (a.low - b.low);
}

/// Some of the rays, from number `first` on.
struct RayPacks
{
  LanePoints origins;
  LanePoints directions;

  HWY_INLINE RayPacks(const RayLanes& rays, int first)
    : origins{ { rays.origin[0] + first, rays.origin[1] + first, rays.origin[2] + first }, 0 }
    , directions{
      { rays.direction[0] + first, rays.direction[1] + first, rays.direction[2] + first }, 0
    }
  {
  }
};

RaySet Surround(const RayLanes& rays, int first, int axis, const RaySet& some,
  const std::array<Vec3, 3>& triangle, TriangleLanes& lanes)
{
  const RayPacks packs(rays, first);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const LanePoint corner[3] = { SplatPoint(triangle[0]), SplatPoint(triangle[1]),
    SplatPoint(triangle[2]) };
  return ForEachPack(some,
    [&](int i, LaneMask /*mask*/) PIXELEXACT_INLINED
    {
      const auto origin = LoadPoint<Lanes>(packs.origins, i);
      const auto direction = LoadPoint<Lanes>(packs.directions, i);
      const Lanes shear[2] = { direction.x[u] / direction.x[axis],
        direction.x[v] / direction.x[axis] };
      Lanes place[3][2];
      ForEachAxis(
        [&](auto k) PIXELEXACT_INLINED
        {
          const LanePoint off = corner[k] - origin;
          place[k][0] = off.x[u] - shear[0] * off.x[axis];
          place[k][1] = off.x[v] - shear[1] * off.x[axis];
        });
      const Lanes zero = Splat(0.0);
      LaneMask left = zero <= zero;
      LaneMask right = left;
      Lanes weight[3];
      ForEachAxis(
        [&](auto k) PIXELEXACT_INLINED
        {
          weight[k] = Across(place[(k + 1) % 3], place[(k + 2) % 3]);
          left = And(left, weight[k] >= zero);
          right = And(right, weight[k] <= zero);
          Store(weight[k], lanes.weight[static_cast<std::size_t>(k)].data() + i);
        });
      // Seen from its edge it is a line.
      return AndNot(Or(left, right), Abs(weight[0] + weight[1] + weight[2]) <= zero);
    });
}

RaySet Meet(const RayLanes& rays, int first, const RaySet& some, const Vec3& corner,
  const Vec3& normal, TriangleLanes& lanes)
{
  const RayPacks packs(rays, first);
  const LanePoint through = SplatPoint(corner);
  const LanePoint across = SplatPoint(normal);
  return ForEachPack(some,
    [&](int i, LaneMask /*mask*/) PIXELEXACT_INLINED
    {
      const auto origin = LoadPoint<Lanes>(packs.origins, i);
      const auto direction = LoadPoint<Lanes>(packs.directions, i);
      const Lanes t = Dot(across, through - origin) / Dot(across, direction);
      const LanePoint onRay = origin + direction * t;
      const LanePoint x = onRay + across * Dot(across, through - onRay);
      Store(t, lanes.t.data() + i);
      ForEachAxis([&](auto d) PIXELEXACT_INLINED
        { Store(x.x[d], lanes.position[static_cast<std::size_t>(d)].data() + i); });
      // Without area it has no normal, and t is no number.
      return And(
        Traits::Load(rays.tNear + first + i) <= t, t <= Traits::Load(rays.tFar + first + i));
    });
}

const TriangleKernels& TriangleKernelSet()
{
  static constexpr TriangleKernels kKernels{ &Surround, &Meet };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(TriangleKernelSet);

const TriangleKernels& GetTriangleKernels()
{
  return HWY_DYNAMIC_DISPATCH(TriangleKernelSet)();
}
} // namespace pixelexact
#endif
