// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/Projection.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace pixelexact
{
Projection::Projection(const CameraView& view, int width, int height)
  : Eye(view.position)
  , Forward(glm::normalize(view.focalPoint - view.position))
  , Right(glm::normalize(glm::cross(Forward, view.viewUp)))
  , Up(glm::cross(Right, Forward))
  , Parallel(view.parallel)
  , Slope(
      2.0 * (Parallel ? view.parallelScale : std::tan(0.5 * glm::radians(view.viewAngle))) / height)
  , Middle{ 0.5 * width, 0.5 * height }
{
}

std::optional<ProjectedPoint> Projection::Of(const Vec3& point) const
{
  const Vec3 from = point - Eye;
  const double forward = glm::dot(from, Forward);
  if (!Parallel && !(forward > 0.0))
  {
    return std::nullopt;
  }
  const double pixel = PixelAt(forward);
  return ProjectedPoint{ { Middle[0] + glm::dot(from, Right) / pixel,
                           Middle[1] + glm::dot(from, Up) / pixel },
    Parallel ? forward : glm::length(from) };
}

Vec3 Projection::AsSeenFrom(const CameraView& view, const Vec3& point) const
{
  const Projection other(view, 2, 2);
  const Vec3 from = point - Eye;
  return other.Eye + glm::dot(from, Right) * other.Right + glm::dot(from, Up) * other.Up +
    glm::dot(from, Forward) * other.Forward;
}
} // namespace pixelexact
