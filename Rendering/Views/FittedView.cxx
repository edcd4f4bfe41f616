// SPDX-License-Identifier: BSD-3-Clause
#include "Views/FittedView.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/Surface.h"
#include "Views/VtkCamera.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace pixelexact
{
Camera CameraOfFilter(
  vtkCamera* camera, const Surface& surface, const Box3& box, int width, int height)
{
  if (camera != nullptr)
  {
    return SetupOf(camera, width, height).Make();
  }
  const Vec3 towards =
    surface.IsFlat() ? SideOfPlane(surface.Normal({ 0.5 * (box.lower + box.upper) })) : Vec3(1.0);
  return { ViewOfBox(box, towards, width, height, Vec3(0.0, 1.0, 0.0), true), width, height };
}

namespace
{
/// Largest part of an image's side that the points fill.
constexpr double kFilled = 0.92;
constexpr int kRounds = 5;
constexpr int kPasses = 2;
/// Passes, where the first ones show too few points.
constexpr int kMaxPasses = 5;
constexpr std::size_t kFewPoints = 30;
/// Number of pixels of the small image.
constexpr double kSmallArea = 1e4;

CameraView FitToPoints(
  std::span<const Vec3> points, const CameraView& all, int width, int height, bool keepScale)
{
  if (points.empty())
  {
    return all;
  }
  const Vec3 towards = glm::normalize(all.position - all.focalPoint);
  const Vec3 right = glm::normalize(glm::cross(all.viewUp, towards));
  const Vec3 up = glm::cross(towards, right);
  const double aspect = static_cast<double>(width) / height;
  const double slope = kFilled * std::tan(0.5 * glm::radians(all.viewAngle));
  CameraView view = all;
  double distance = glm::distance(all.position, all.focalPoint);
  // A focal point far in front of all points could not be approached.
  double nearest = -std::numeric_limits<double>::infinity();
  for (const Vec3& point : points)
  {
    nearest = std::max(nearest, glm::dot(point - view.focalPoint, towards));
  }
  if (nearest < 0.0)
  {
    view.focalPoint += nearest * towards;
    distance -= nearest;
  }
  // In a perspective view, the middle of the points' image is not the image of their middle. Each
  // round moves the view to the former, and as near as possible.
  for (int round = 0; round < kRounds; ++round)
  {
    glm::dvec2 lower(std::numeric_limits<double>::infinity());
    glm::dvec2 upper = -lower;
    for (const Vec3& point : points)
    {
      const Vec3 from = point - view.focalPoint;
      const double near = view.parallel ? 1.0 : distance / (distance - glm::dot(from, towards));
      const glm::dvec2 at = near * glm::dvec2(glm::dot(from, right), glm::dot(from, up));
      lower = glm::min(lower, at);
      upper = glm::max(upper, at);
    }
    const glm::dvec2 middle = 0.5 * (lower + upper);
    view.focalPoint += middle.x * right + middle.y * up;
    distance = 0.0;
    view.parallelScale = 0.0;
    for (const Vec3& point : points)
    {
      const Vec3 from = point - view.focalPoint;
      const double beside =
        std::max(std::fabs(glm::dot(from, up)), std::fabs(glm::dot(from, right)) / aspect);
      distance = std::max(distance, glm::dot(from, towards) + beside / slope);
      view.parallelScale = std::max(view.parallelScale, beside / kFilled);
    }
    // A single point, or a line seen end-on, gives no scale.
    if (!(view.parallelScale > 1e-6 * all.parallelScale))
    {
      return all;
    }
  }
  view.position = view.focalPoint + distance * towards;
  view.parallelScale = keepScale ? all.parallelScale : view.parallelScale;
  view = AsHeld(view);
  try
  {
    (void)Camera(view, width, height);
  }
  catch (const Error&)
  {
    // The position is so near that rounding leaves no direction.
    return all;
  }
  return view;
}
} // namespace

Vec3 SideOfPlane(const Vec3& normal)
{
  return normal.x == 0.0 && normal.y > 0.0 && normal.z == 0.0 ? -normal : normal;
}

Vec3 UsualUp(const Vec3& towardsViewer)
{
  const bool alongZ =
    std::abs(towardsViewer.z) > 0.9 * std::hypot(towardsViewer.x, towardsViewer.y, towardsViewer.z);
  return alongZ ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
}

std::array<int, 2> SmallSize(int width, int height)
{
  const double part = std::min(1.0, std::sqrt(kSmallArea / width / height));
  const auto side = [part](int all) { return std::max(1, static_cast<int>(part * all)); };
  return { side(width), side(height) };
}

CameraView FitView(
  const CameraView& all, int width, int height, bool keepScale, const SeenFrom& seen)
{
  CameraView view = all;
  for (int look = 0, passes = kPasses; look < passes; ++look)
  {
    const std::vector<Vec3> points = seen(view);
    view = FitToPoints(points, view, width, height, keepScale);
    // The next pass shows more of a small surface.
    passes = !points.empty() && points.size() < kFewPoints && look + 1 == passes
      ? std::min(passes + 1, kMaxPasses)
      : passes;
  }
  return view;
}
} // namespace pixelexact
