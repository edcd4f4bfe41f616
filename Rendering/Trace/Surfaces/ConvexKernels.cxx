// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Surfaces/ConvexKernels.cxx"
#include <hwy/foreach_target.h>

#include "Trace/Surfaces/PairRay-inl.h"
#include "Trace/Surfaces/SurfaceKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
HWY_INLINE void SplatTo(const Vec3& x, Lanes (&to)[3])
{
  to[0] = Splat(x.x);
  to[1] = Splat(x.y);
  to[2] = Splat(x.z);
}

/// A pack of rays, and the t where they enter and leave.
struct ConvexRay
{
  Lanes origin[3];
  Lanes direction[3];
  Lanes enter;
  Lanes exit;
  Lanes enterFace;
  Lanes exitFace;
  LaneMask outside; ///< parallel to a face, on its outer side

  HWY_INLINE ConvexRay(const RayLanes& rays, int at)
    : enter(Splat(-kNoHit))
    , exit(Splat(kNoHit))
    , enterFace(Splat(0.0))
    , exitFace(Splat(0.0))
    , outside(enter < enter)
  {
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        origin[d] = NumberTraits<Lanes>::Load(rays.origin[d] + at);
        direction[d] = NumberTraits<Lanes>::Load(rays.direction[d] + at);
      });
  }

  HWY_INLINE void Cut(const ConvexFace& face, int number)
  {
    Lanes normal[3];
    Lanes distance[3];
    SplatTo(face.normal, normal);
    SplatTo(face.point, distance);
    ForEachAxis([&](auto d) PIXELEXACT_INLINED { distance[d] = distance[d] - origin[d]; });
    const Lanes zero = Splat(0.0);
    const Lanes height = PlainDot(normal, distance);
    const Lanes slope = PlainDot(normal, direction);
    const Lanes t = height / slope;
    const LaneMask enters = And(slope < zero, enter < t);
    const LaneMask leaves = And(zero < slope, t < exit);
    enter = Select(enters, t, enter);
    exit = Select(leaves, t, exit);
    enterFace = Select(enters, Splat(number), enterFace);
    exitFace = Select(leaves, Splat(number), exitFace);
    outside = Or(outside, And(Abs(slope) <= zero, height < zero));
  }

  /// Writes the hits at t on the given faces to slot k.
  void Put(const ConvexFace* faces, Lanes t, Lanes number, LaneMask hit, int k, int at,
    HitSlots& hits) const
  {
    double ofLane[kLanePadding];
    double planes[6][kLanePadding];
    Store(number, ofLane);
    const HitLanes slot = hits.Slot(k);
    const PieceLanes pieces = hits.Pieces(k);
    const std::uint64_t bits = BitsOf(hit);
    for (int lane = 0; lane < LaneCount(); ++lane)
    {
      const auto face = static_cast<std::int32_t>(ofLane[lane]);
      for (int d = 0; d < 3; ++d)
      {
        planes[d][lane] = faces[face].point[d];
        planes[3 + d][lane] = faces[face].normal[d];
      }
      pieces.piece[at + lane] = ((bits >> static_cast<unsigned>(lane)) & 1U) != 0 ? face : -1;
    }
    using Traits = NumberTraits<Lanes>;
    Lanes x[3];
    Lanes off[3];
    Lanes normal[3];
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED
      {
        x[d] = origin[d] + t * direction[d];
        off[d] = x[d] - Traits::Load(planes[d]);
        normal[d] = Traits::Load(planes[3 + d]);
      });
    // With a far origin, the rounding of t moves x off the face; x is moved back along the normal.
    const Lanes height = PlainDot(normal, off);
    Store(Select(hit, t, Splat(kNoHit)), slot.t + at);
    ForEachAxis(
      [&](auto d) PIXELEXACT_INLINED { Store(x[d] - normal[d] * height, slot.position[d] + at); });
  }
};

void MeetConvex(const ConvexFace* faces, int count, const RayLanes& rays, HitSlots& hits)
{
  for (int i = 0; i < rays.count; i += LaneCount())
  {
    ConvexRay ray(rays, i);
    for (int face = 0; face < count; ++face)
    {
      ray.Cut(faces[face], face);
    }
    const LaneMask meets =
      AndNot(And(RaysOfPack(i, rays.count), ray.enter <= ray.exit), ray.outside);
    const LaneMask in1 = And(meets, WithinEnds(rays, i, ray.enter));
    const LaneMask in2 = And(And(meets, WithinEnds(rays, i, ray.exit)), ray.enter < ray.exit);
    if (None(Or(in1, in2)))
    {
      continue;
    }
    const Lanes face = Select(in1, ray.enterFace, ray.exitFace);
    ray.Put(faces, Select(in1, ray.enter, ray.exit), face, Or(in1, in2), 0, i, hits);
    const LaneMask both = And(in1, in2);
    if (!None(both))
    {
      ray.Put(faces, ray.exit, ray.exitFace, both, 1, i, hits);
    }
  }
}

const ConvexKernels& ConvexKernelSet()
{
  static constexpr ConvexKernels kKernels{ &MeetConvex };
  return kKernels;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(ConvexKernelSet);

const ConvexKernels& GetConvexKernels()
{
  return HWY_DYNAMIC_DISPATCH(ConvexKernelSet)();
}
} // namespace pixelexact
#endif
