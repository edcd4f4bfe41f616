// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/TriangleKernels.cxx"
#include <hwy/foreach_target.h>

#include "Core/Math/Pair-inl.h"
#include "Trace/LanePoint-inl.h"
#include "Trace/Surfaces/Curved/GatheredRays-inl.h"
#include "Trace/Surfaces/SurfaceKernels.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
/// p.x q.y - p.y q.x, twice the area of the triangle with the origin. Its sign is exact, it is 0
/// only if the exact value is, and exchanging p and q negates it to the bit.
HWY_INLINE Lanes Across(const Lanes (&p)[2], const Lanes (&q)[2])
{
  const Pair a = ExactProduct(p[0], q[1]);
  const Pair b = ExactProduct(p[1], q[0]);
  // Exact if the products are close; otherwise their rounding errors do not matter.
  return (a.high - b.high) + (a.low - b.low);
}

/// The origins and directions of the rays from number `first` on.
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

/// A triangle in the bundle's axes, with depths from its z0.
struct SeenTriangle
{
  Lanes corner[3][3];
  Lanes lower[3];
  Lanes upper[3];

  HWY_INLINE SeenTriangle(const std::array<Vec3, 3>& triangle, const RayBundle& bundle)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const int axis = bundle.axes[a];
      const double zero = a == 2 ? bundle.z0 : 0.0;
      const double x[3] = { triangle[0][axis] - zero, triangle[1][axis] - zero,
        triangle[2][axis] - zero };
      lower[a] = Splat(std::min(std::min(x[0], x[1]), x[2]));
      upper[a] = Splat(std::max(std::max(x[0], x[1]), x[2]));
      for (std::size_t k = 0; k < 3; ++k)
      {
        corner[k][a] = Splat(x[k]);
      }
    }
  }
};

/// The test of PieceKernels::meetBox for a pack.
HWY_INLINE LaneMask MayMeet(const RayBundle& bundle, int i, const SeenTriangle& seen)
{
  const auto load = [i](const RayBundle::Numbers& numbers) PIXELEXACT_INLINED
  { return Traits::Load(numbers.data() + i); };
  const Lanes slack = load(bundle.slack);
  const Lanes lower = seen.lower[2];
  const Lanes upper = seen.upper[2];
  const Lanes sign = Splat(bundle.sign);
  LaneMask may = And(Max(sign * lower, sign * upper) + slack >= load(bundle.near),
    Min(sign * lower, sign * upper) - slack <= load(bundle.far));
  for (std::size_t a = 0; a < 2; ++a)
  {
    const Lanes place = load(bundle.place[a]);
    const Lanes slope = load(bundle.slope[a]);
    const Lanes p = place + slope * lower;
    const Lanes q = place + slope * upper;
    may = And(may, And(Min(p, q) - slack <= seen.upper[a], Max(p, q) + slack >= seen.lower[a]));
  }
  return may;
}

RaySet Meet(const RayBundle& bundle, const RayLanes& rays, const RaySet& some,
  const std::array<Vec3, 3>& triangle, const Vec3& normal, TriangleLanes& lanes)
{
  const RayPacks packs(rays, bundle.First());
  const SeenTriangle seen(triangle, bundle);
  const LanePoint corner = SplatPoint(triangle[0]);
  const LanePoint normals = SplatPoint(normal);
  const Lanes zero = Splat(0.0);
  lanes.across = {};
  return ForEachPack(some,
    [&](int i, LaneMask mask) PIXELEXACT_INLINED
    {
      const auto at = static_cast<std::size_t>(i);
      LaneMask met = And(mask, MayMeet(bundle, i, seen));
      if (None(met))
      {
        return met;
      }
      Lanes place[3][2];
      for (std::size_t a = 0; a < 2; ++a)
      {
        const Lanes ray = Traits::Load(&bundle.place[a][at]);
        const Lanes slope = Traits::Load(&bundle.slope[a][at]);
        for (std::size_t k = 0; k < 3; ++k)
        {
          place[k][a] = seen.corner[k][a] - (ray + slope * seen.corner[k][2]);
        }
      }
      LaneMask left = met;
      LaneMask right = met;
      Lanes weight[3];
      ForEachAxis(
        [&](auto k) PIXELEXACT_INLINED
        {
          weight[k] = Across(place[(k + 1) % 3], place[(k + 2) % 3]);
          left = And(left, weight[k] >= zero);
          right = And(right, weight[k] <= zero);
        });
      const Lanes sum = weight[0] + weight[1] + weight[2];
      // A triangle seen edge-on is a line.
      met = AndNot(Or(left, right), Abs(sum) <= zero);
      if (None(met))
      {
        return met;
      }
      const auto origin = LoadPoint<Lanes>(packs.origins, i);
      const auto direction = LoadPoint<Lanes>(packs.directions, i);
      const Lanes t = Dot(normals, corner - origin) / Dot(normals, direction);
      const LanePoint onRay = origin + direction * t;
      const LanePoint x = onRay + normals * Dot(normals, corner - onRay);
      const Lanes share = Splat(1.0) / sum;
      Store(t, &lanes.t[at]);
      Store(weight[1] * share, &lanes.weight[0][at]);
      Store(weight[2] * share, &lanes.weight[1][at]);
      ForEachAxis(
        [&](auto d) PIXELEXACT_INLINED
        {
          const auto k = static_cast<std::size_t>(d);
          Store(x.x[d], &lanes.position[k][at]);
          lanes.across[k].bits[at / 64] |= BitsOf(Abs(weight[d]) <= zero) << (at % 64);
        });
      const auto end = static_cast<std::size_t>(bundle.First());
      // A triangle without area has no normal, and t is NaN.
      return And(met,
        And(Traits::Load(rays.tNear + end + at) <= t, t <= Traits::Load(rays.tFar + end + at)));
    });
}

const TriangleKernels& TriangleKernelSet()
{
  static constexpr TriangleKernels kKernels{ &Meet };
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
