// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Index/EmbreeBvh.h"

#include "Core/Base/Error.h"
#include "Core/Index/EmbreeApi.h"
#include "Core/Math/Rounding.h"

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace pixelexact
{
namespace
{
struct FloatBox
{
  float lower[3];
  float upper[3];
};

struct QueryState
{
  FloatBox region;
  const std::vector<FloatBox>* boxes;
  std::vector<int>* out;
};

bool Overlap(const FloatBox& a, const FloatBox& b)
{
  return a.lower[0] <= b.upper[0] && b.lower[0] <= a.upper[0] && a.lower[1] <= b.upper[1] &&
    b.lower[1] <= a.upper[1] && a.lower[2] <= b.upper[2] && b.lower[2] <= a.upper[2];
}

bool Collect(RTCPointQueryFunctionArguments* arguments)
{
  auto& state = *static_cast<QueryState*>(arguments->userPtr);
  // Embree's leaves may hold boxes that the query's sphere does not meet.
  if (Overlap(state.region, (*state.boxes)[arguments->primID]))
  {
    state.out->push_back(static_cast<int>(arguments->primID));
  }
  return false; // the radius stays
}

/// The context that an occlusion function receives with its ray.
struct AlongState
{
  EmbreeContext context; ///< first: Embree hands out its address
  std::vector<int>* out;
};

void CollectAlong(const RTCOccludedFunctionNArguments* arguments)
{
  // Reports the ray as not occluded, so that it continues.
  reinterpret_cast<AlongState*>(arguments->context)
    ->out->push_back(static_cast<int>(arguments->primID));
}

/// The widening of boxes. A segment's points, as floats, are off by 2^-24 for one of its ends (at
/// most 1 in size), and by twice that for the way to the other; Embree assumes sides of a box to be
/// off by 2^-23; most of the rest is for the segment's slack.
constexpr float kBoxSlack = 0x1p-20F;
constexpr double kMaxSlack = 0x1p-21;

/// Floats are precise to 2^-24 relative to coordinates of at most 1; Embree's own distances are
/// sums of a few such terms.
constexpr float kRadiusSlack = 1e-6F;
} // namespace

struct Bvh::Implementation
{
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  Vec3 centre{ 0.0 };
  double scale = 1.0;
  std::vector<FloatBox> boxes;
  std::atomic<std::int64_t> bytes{ 0 };

  ~Implementation()
  {
    if (scene)
    {
      rtcReleaseScene(scene);
    }
    if (device)
    {
      rtcReleaseDevice(device);
    }
  }

  [[nodiscard]] FloatBox ToFloat(const Box3& box) const
  {
    FloatBox result{};
    for (int d = 0; d < 3; ++d)
    {
      result.lower[d] = FloatDown((box.lower[d] - centre[d]) * scale);
      result.upper[d] = FloatUp((box.upper[d] - centre[d]) * scale);
    }
    return result;
  }
};

Bvh::Bvh(std::span<const Box3> boxes, const Box3& bounds)
  : Impl(std::make_unique<Implementation>())
{
  double extent = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    Impl->centre[d] = 0.5 * bounds.lower[d] + 0.5 * bounds.upper[d];
    extent = std::max(extent, 0.5 * bounds.upper[d] - 0.5 * bounds.lower[d]);
  }
  Impl->scale = extent > 0.0 ? std::exp2(-std::ceil(std::log2(extent))) : 1.0;
  Impl->boxes.reserve(boxes.size());
  for (const auto& box : boxes)
  {
    Impl->boxes.push_back(Impl->ToFloat(box));
  }

  Impl->device = rtcNewDevice(nullptr);
  if (!Impl->device)
  {
    throw Error("Embree could not make a device; is the processor supported by it?");
  }
  rtcSetDeviceMemoryMonitorFunction(
    Impl->device,
    [](void* user, ssize_t bytes, bool /*post*/)
    {
      static_cast<Implementation*>(user)->bytes += bytes;
      return true;
    },
    Impl.get());
  Impl->scene = rtcNewScene(Impl->device);
  RTCGeometry geometry = rtcNewGeometry(Impl->device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry, Impl.get());
  rtcSetGeometryBoundsFunction(
    geometry,
    [](const RTCBoundsFunctionArguments* arguments)
    {
      const auto& box =
        static_cast<const Implementation*>(arguments->geometryUserPtr)->boxes[arguments->primID];
      auto& out = *arguments->bounds_o;
      out.lower_x = box.lower[0] - kBoxSlack;
      out.lower_y = box.lower[1] - kBoxSlack;
      out.lower_z = box.lower[2] - kBoxSlack;
      out.upper_x = box.upper[0] + kBoxSlack;
      out.upper_y = box.upper[1] + kBoxSlack;
      out.upper_z = box.upper[2] + kBoxSlack;
    },
    nullptr);
  rtcSetGeometryOccludedFunction(geometry, &CollectAlong);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(Impl->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(Impl->scene);
  if (const RTCError error = rtcGetDeviceError(Impl->device); error != RTC_ERROR_NONE)
  {
    throw Error("Embree could not build the hierarchy over " + std::to_string(boxes.size()) +
      " boxes (error " + std::to_string(error) + "); is there enough memory?");
  }
}

Bvh::~Bvh() = default;

void Bvh::Query(const Box3& region, std::vector<int>& out) const
{
  out.clear();
  QueryState state{ Impl->ToFloat(region), &Impl->boxes, &out };
  RTCPointQuery query{};
  double square = 0.0;
  float middle[3];
  for (int d = 0; d < 3; ++d)
  {
    middle[d] = 0.5F * state.region.lower[d] + 0.5F * state.region.upper[d];
    const double half =
      std::max(static_cast<double>(state.region.upper[d]) - static_cast<double>(middle[d]),
        static_cast<double>(middle[d]) - static_cast<double>(state.region.lower[d]));
    square += half * half;
  }
  query.x = middle[0];
  query.y = middle[1];
  query.z = middle[2];
  query.time = 0.0F;
  query.radius = FloatUp(std::sqrt(square)) * (1.0F + kRadiusSlack) + kRadiusSlack;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(Impl->scene, &query, &context, &Collect, &state);
  std::ranges::sort(out);
}

void Bvh::QueryAlong(const Segment& segment, std::vector<int>& out) const
{
  if (segment.slack * Impl->scale > kMaxSlack)
  {
    const Vec3 slack(segment.slack);
    Query(
      { glm::min(segment.from, segment.to) - slack, glm::max(segment.from, segment.to) + slack },
      out);
    return;
  }
  out.clear();
  AlongState state{};
  BeginContext(state.context);
  state.out = &out;
  const Vec3 origin = (segment.from - Impl->centre) * Impl->scale;
  const Vec3 way = (segment.to - segment.from) * Impl->scale;
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(way.x);
  ray.dir_y = static_cast<float>(way.y);
  ray.dir_z = static_cast<float>(way.z);
  ray.tfar = 1.0F;
  ray.mask = ~0U;
  CallAlong(Impl->scene, state.context, ray);
  std::ranges::sort(out);
}

std::size_t Bvh::MemoryUsage() const
{
  return Impl->boxes.capacity() * sizeof(FloatBox) + static_cast<std::size_t>(Impl->bytes.load());
}
} // namespace pixelexact
