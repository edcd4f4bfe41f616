// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Projection.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace pixelexact
{
CameraAxes AxesOf(const CameraView& view)
{
  const Vec3 forward = glm::normalize(view.focalPoint - view.position);
  const Vec3 right = glm::normalize(glm::cross(forward, view.viewUp));
  return { forward, right, glm::cross(right, forward) };
}

Projection::Projection(const CameraView& view, int width, int height)
  : Eye(view.position)
  , Axes(AxesOf(view))
  , Parallel(view.parallel)
  , Slope(
      2.0 * (Parallel ? view.parallelScale : std::tan(0.5 * glm::radians(view.viewAngle))) / height)
  , Middle{ 0.5 * width, 0.5 * height }
{
}

std::optional<ProjectedPoint> Projection::Of(const Vec3& point) const
{
  const Vec3 from = point - Eye;
  const double forward = glm::dot(from, Axes.forward);
  if (!Parallel && !(forward > 0.0))
  {
    return std::nullopt;
  }
  const double pixel = PixelAt(forward);
  return ProjectedPoint{ { Middle[0] + glm::dot(from, Axes.right) / pixel,
                           Middle[1] + glm::dot(from, Axes.up) / pixel },
    Parallel ? forward : glm::length(from) };
}

Vec3 Projection::AsSeenFrom(const CameraView& view, const Vec3& point) const
{
  const Projection other(view, 2, 2);
  const Vec3 from = point - Eye;
  return other.Eye + glm::dot(from, Axes.right) * other.Axes.right +
    glm::dot(from, Axes.up) * other.Axes.up + glm::dot(from, Axes.forward) * other.Axes.forward;
}
} // namespace pixelexact
