// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Surfaces/Surface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace pixelexact
{
void Surface::Normals(std::span<const SurfacePoint> points, std::span<Vec3> normals) const
{
  std::ranges::transform(
    points, normals.begin(), [this](const SurfacePoint& point) { return Normal(point); });
}

double Surface::Sagitta(const Ray& /*a*/, const SurfacePoint& /*atA*/, const Ray& /*b*/,
  const SurfacePoint& /*atB*/) const
{
  return IsFlat() ? 0.0 : std::numeric_limits<double>::infinity();
}

double Surface::SagittaOver(
  const std::array<Ray, 3>& /*rays*/, const std::array<Vec3, 3>& /*hits*/) const
{
  return IsFlat() ? 0.0 : std::numeric_limits<double>::infinity();
}

double Surface::Reach(const Chord& /*chord*/) const
{
  return std::numeric_limits<double>::infinity();
}

bool Surface::IsClearOf(const Vec3& /*centre*/, double /*radius*/) const
{
  return false;
}

std::optional<double> Surface::HeldValue(const Field& /*field*/, int /*component*/) const
{
  return std::nullopt;
}

bool Surface::MayMeet(const Outline& part, double slack, EdgeWork* /*work*/) const
{
  const Vec3 middle = part.Middle();
  double farthest = 0.0;
  for (const Vec3& corner : part.Corners())
  {
    farthest = std::max(farthest, glm::distance(middle, corner));
  }
  return !IsClearOf(middle, (1.0 + 1e-12) * farthest + 2.0 * slack);
}

std::vector<Hit> HitsOf(const Surface& surface, const Ray& ray, double tNear, double tFar)
{
  double lanes[8][kLanePadding];
  for (int d = 0; d < 3; ++d)
  {
    std::fill_n(lanes[d], kLanePadding, ray.origin[d]);
    std::fill_n(lanes[3 + d], kLanePadding, ray.direction[d]);
  }
  std::fill_n(lanes[6], kLanePadding, tNear);
  std::fill_n(lanes[7], kLanePadding, tFar);
  HitSlots slots;
  slots.Begin(1);
  surface.Meet(
    { { lanes[0], lanes[1], lanes[2] }, { lanes[3], lanes[4], lanes[5] }, lanes[6], lanes[7], 1 },
    slots);
  std::vector<Hit> hits;
  for (int k = 0; k < slots.Count() && slots.T(k)[0] < kNoHit; ++k)
  {
    hits.push_back({ slots.T(k)[0], slots.PointOf(k, 0).position, slots.StatusOf(k, 0) });
  }
  return hits;
}
} // namespace pixelexact
