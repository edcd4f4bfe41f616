// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The one file that depends on Embree's version: 3 and 4 differ in their folder, and in how a ray
// gets its callback.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace pixelexact
{
#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;

inline void BeginContext(EmbreeContext& context)
{
  rtcInitRayQueryContext(&context);
}
inline void CallAlong(RTCScene scene, EmbreeContext& context, RTCRay& ray)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}
#else
using EmbreeContext = RTCIntersectContext;

inline void BeginContext(EmbreeContext& context)
{
  rtcInitIntersectContext(&context);
}
/// Calls the geometry's occlusion function for all boxes that the ray may meet.
inline void CallAlong(RTCScene scene, EmbreeContext& context, RTCRay& ray)
{
  rtcOccluded1(scene, &context, &ray);
}
#endif
} // namespace pixelexact
