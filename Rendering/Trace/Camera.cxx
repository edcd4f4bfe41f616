// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Camera.h"

#include "Core/Base/Error.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace pixelexact
{
namespace
{
bool IsFinite(const Vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void RequireSize(int width, int height)
{
  if (width < 1 || height < 1)
  {
    throw Error("an image of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels has no rays; give at least 1 x 1.");
  }
}

void Require(bool condition, const char* message)
{
  if (!condition)
  {
    throw Error(std::string("camera: ") + message);
  }
}
} // namespace

Camera::Camera(const CameraView& view, int width, int height)
  : ImageWidth(width)
  , ImageHeight(height)
{
  RequireSize(width, height);
  Require(IsFinite(view.position) && IsFinite(view.focalPoint) && IsFinite(view.viewUp) &&
      std::isfinite(view.windowCenter[0]) && std::isfinite(view.windowCenter[1]),
    "a position, direction or window centre is not a finite number.");
  const Vec3 sight = view.focalPoint - view.position;
  Require(glm::length(sight) > 0.0, "position and focal point coincide; move one of them.");
  const Vec3 forward = sight / glm::length(sight);
  const Vec3 side = glm::cross(forward, view.viewUp);
  Require(glm::length(side) > 1e-12 * glm::length(view.viewUp),
    "view-up is zero or parallel to the direction of view; choose another.");
  const Vec3 right = side / glm::length(side);
  const Vec3 up = glm::cross(right, forward);

  const double aspect = static_cast<double>(width) / height;
  double halfHeight = 0.0;
  if (view.parallel)
  {
    Require(view.parallelScale > 0.0 && std::isfinite(view.parallelScale),
      "the parallel scale must be positive.");
    halfHeight = view.parallelScale;
  }
  else
  {
    Require(view.viewAngle > 0.0 && view.viewAngle < 180.0,
      "the view angle must lie between 0 and 180 degrees.");
    halfHeight = std::tan(view.viewAngle * std::numbers::pi / 360.0);
    halfHeight /= view.horizontalViewAngle ? aspect : 1.0;
  }
  auto& [origin, direction] = rays_;
  const Vec3 u = right * (halfHeight * aspect);
  const Vec3 v = up * halfHeight;
  const Vec3 offset = u * view.windowCenter[0] + v * view.windowCenter[1];
  if (view.parallel)
  {
    origin = { view.position + offset, u, v };
    direction.constant = forward;
  }
  else
  {
    origin.constant = view.position;
    direction = { forward + offset, u, v };
  }
}

Camera::Camera(const std::array<double, 16>& inverseProjection, int width, int height)
  : ImageWidth(width)
  , ImageHeight(height)
{
  RequireSize(width, height);
  const auto& m = inverseProjection;
  const auto column = [&](int c) { return Vec3(m[c], m[4 + c], m[8 + c]); };
  for (const double entry : m)
  {
    Require(std::isfinite(entry), "the projection matrix is singular or not finite.");
  }
  auto& [origin, direction] = rays_;
  const Vec3 depth = column(2);
  const double depthW = m[14];
  // All rays meet in the image of the direction (0, 0, 1, 0): the eye, or a point at infinity.
  if (depthW != 0.0)
  {
    const Vec3 eye = depth / depthW;
    const double sign = m[15] - depthW > 0.0 ? 1.0 : -1.0;
    origin.constant = eye;
    direction = { (column(3) - eye * m[15]) * sign, (column(0) - eye * m[12]) * sign,
      (column(1) - eye * m[13]) * sign };
  }
  else
  {
    Require(m[12] == 0.0 && m[13] == 0.0 && m[15] != 0.0, "the matrix describes no projection.");
    origin = { (column(3) - depth) / m[15], column(0) / m[15], column(1) / m[15] };
    direction.constant = depth / m[15];
  }
  Require(glm::length(direction.constant) > 0.0, "the matrix describes no direction of view.");
}

Ray Camera::At(double px, double py) const
{
  const double u = U(px);
  const double v = V(py);
  const auto& [origin, direction] = rays_;
  const Vec3 to = direction.constant + direction.u * u + direction.v * v;
  return { origin.constant + origin.u * u + origin.v * v, to * (1.0 / glm::length(to)) };
}

Vec3 Camera::ViewDirection() const
{
  return rays_.direction.constant / glm::length(rays_.direction.constant);
}
} // namespace pixelexact
