// SPDX-License-Identifier: BSD-3-Clause
// Points of space in lanes. Sums and products are rounded one by one, as glm's are.
#if defined(PIXELEXACT_LANE_POINT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELEXACT_LANE_POINT_INL_H
#undef PIXELEXACT_LANE_POINT_INL_H
#else
#define PIXELEXACT_LANE_POINT_INL_H
#endif

#include "Core/Element/Matrix-inl.h"
#include "Trace/Camera.h"

HWY_BEFORE_NAMESPACE();
namespace pixelexact::HWY_NAMESPACE
{
using LanePoint = Point<Lanes>;

HWY_INLINE LanePoint SplatPoint(const Vec3& x)
{
  return { { Splat(x.x), Splat(x.y), Splat(x.z) } };
}

HWY_INLINE LanePoint operator+(const LanePoint& a, const LanePoint& b)
{
  return { { a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2] } };
}

HWY_INLINE LanePoint operator-(const LanePoint& a, const LanePoint& b)
{
  return { { a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2] } };
}

HWY_INLINE LanePoint operator*(const LanePoint& a, Lanes s)
{
  return { { a.x[0] * s, a.x[1] * s, a.x[2] * s } };
}

HWY_INLINE Lanes Dot(const LanePoint& a, const LanePoint& b)
{
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

HWY_INLINE LanePoint Cross(const LanePoint& a, const LanePoint& b)
{
  return { { a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
    a.x[0] * b.x[1] - a.x[1] * b.x[0] } };
}

HWY_INLINE LanePoint Normalized(const LanePoint& x)
{
  return x * (Splat(1.0) / Sqrt(Dot(x, x)));
}

/// A point that is linear in u and v, with its constants in lanes.
struct LinearLanes
{
  LanePoint constant;
  LanePoint u;
  LanePoint v;

  explicit HWY_INLINE LinearLanes(const CameraRays::Linear& linear)
    : constant(SplatPoint(linear.constant))
    , u(SplatPoint(linear.u))
    , v(SplatPoint(linear.v))
  {
  }

  [[nodiscard]] HWY_INLINE LanePoint At(Lanes atU, Lanes atV) const
  {
    return constant + u * atU + v * atV;
  }
};
} // namespace pixelexact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
