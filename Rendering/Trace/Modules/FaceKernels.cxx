// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Trace/Modules/FaceKernels.cxx"
#include <hwy/foreach_target.h>

#include "Trace/LanePoint-inl.h"
#include "Trace/Modules/FaceKernels.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
void FindNear(const CameraRays& camera, const FaceReach& reach, const FacePixels& pixels,
  const std::array<const double*, 9>& jacobian, std::uint8_t* near)
{
  using Traits = NumberTraits<Lanes>;
  const LinearLanes origins(camera.origin);
  const LinearLanes directions(camera.direction);
  for (std::size_t i = 0; i < pixels.Count(); i += static_cast<std::size_t>(LaneCount()))
  {
    const auto load = [&](std::size_t k) PIXELEXACT_INLINED
    { return Traits::Load(pixels.Column(k) + i); };
    const auto loadAll = [&](std::size_t k) PIXELEXACT_INLINED {
      return LanePoint{ { load(k), load(k + 1), load(k + 2) } };
    };
    const Lanes u = load(0);
    const Lanes v = load(1);
    const LanePoint xi = loadAll(2);
    const LanePoint normal = loadAll(8);
    const LanePoint from = loadAll(5) - origins.At(u, v);
    const LanePoint along = directions.At(u, v);
    const Lanes t = Dot(from, along) / Dot(along, along);
    const Lanes facing = Dot(normal, along);
    // Movement of the surface's point as the ray moves by a pixel, times `facing`.
    const auto moves = [&](const Vec3& origin, const Vec3& direction, double pixel)
                         PIXELEXACT_INLINED
    {
      const LanePoint moved = (SplatPoint(origin) + SplatPoint(direction) * t) * Splat(pixel);
      return moved * facing - along * Dot(normal, moved);
    };
    const LanePoint across = moves(camera.origin.u, camera.direction.u, reach.across);
    const LanePoint up = moves(camera.origin.v, camera.direction.v, reach.up);
    LanePoint columns[3];
    for (std::size_t d = 0; d < 3; ++d)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        columns[d].x[c] = Traits::Load(jacobian[3 * c + d] + i);
      }
    }
    // Rows of the inverse, times the determinant.
    const LanePoint rows[3] = { Cross(columns[1], columns[2]), Cross(columns[2], columns[0]),
      Cross(columns[0], columns[1]) };
    const auto times = [&rows](const LanePoint& by) PIXELEXACT_INLINED {
      return LanePoint{ { Dot(rows[0], by), Dot(rows[1], by), Dot(rows[2], by) } };
    };
    const LanePoint xiAcross = times(across);
    const LanePoint xiUp = times(up);
    const Lanes unit = Abs(Dot(columns[0], rows[0]) * Splat(reach.size) * facing);
    LaneMask far = unit >= Splat(0.0);
    for (const FacePlane& face : reach.faces)
    {
      const LanePoint gradient = SplatPoint(face.gradient);
      const Lanes distance = (Dot(gradient, xi) + Splat(face.constant)) * unit;
      const Lanes x = Splat(reach.reach) * Dot(gradient, xiAcross);
      const Lanes y = Splat(reach.reach) * Dot(gradient, xiUp);
      far = And(far, And(Splat(0.0) < distance, distance * distance >= x * x + y * y));
    }
    const std::uint64_t bits = BitsOf(far);
    for (std::size_t k = 0; k < static_cast<std::size_t>(LaneCount()) && i + k < pixels.Count();
         ++k)
    {
      near[i + k] = (bits >> k & 1U) != 0 ? 0 : 1;
    }
  }
}

const FaceKernels& FaceKernelTable()
{
  static constexpr FaceKernels kTable{ &FindNear };
  return kTable;
}
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pixelexact
{
HWY_EXPORT(FaceKernelTable);

const FaceKernels& GetFaceKernels()
{
  return HWY_DYNAMIC_DISPATCH(FaceKernelTable)();
}
} // namespace pixelexact
#endif
