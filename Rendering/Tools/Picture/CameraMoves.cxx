// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/CameraMoves.h"

#include "Trace/Projection.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace pixelexact
{
Vec3 Rotated(const Vec3& v, const Vec3& axis, double angle)
{
  return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
    (1.0 - std::cos(angle)) * glm::dot(axis, v) * axis;
}

CameraView Turned(const CameraView& view, double right, double up)
{
  const CameraAxes axes = AxesOf(view);
  CameraView turned = view;
  const auto turn = [&](const Vec3& v)
  { return Rotated(Rotated(v, axes.right, up), axes.up, -right); };
  turned.position = view.focalPoint + turn(view.position - view.focalPoint);
  turned.viewUp = turn(axes.up);
  return turned;
}

CameraView Moved(const CameraView& view, double right, double up)
{
  const CameraAxes axes = AxesOf(view);
  const double height = 2.0 *
    (view.parallel ? view.parallelScale
                   : glm::distance(view.position, view.focalPoint) *
          std::tan(glm::radians(0.5 * view.viewAngle)));
  const Vec3 offset = height * (right * axes.right + up * axes.up);
  CameraView moved = view;
  moved.position -= offset;
  moved.focalPoint -= offset;
  return moved;
}

CameraView Zoomed(const CameraView& view, double factor)
{
  CameraView zoomed = view;
  if (view.parallel)
  {
    zoomed.parallelScale /= factor;
  }
  else
  {
    zoomed.position = view.focalPoint + (view.position - view.focalPoint) / factor;
  }
  return zoomed;
}
} // namespace pixelexact
