// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/CameraOptions.h"

#include "Base/Command.h"
#include "Base/Options.h"

#include "Core/Base/Error.h"
#include "Views/VtkCamera.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
Vec3 ToVec3(const std::vector<double>& v)
{
  return { v[0], v[1], v[2] };
}

/// z points up, as in most drawings of solids, except where one looks along it.
Vec3 UsualUp(const Vec3& towardsViewer)
{
  const bool alongZ =
    std::abs(towardsViewer.z) > 0.9 * std::hypot(towardsViewer.x, towardsViewer.y, towardsViewer.z);
  return alongZ ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
}
/// Of an image's side, at most.
constexpr double kFilled = 0.92;
constexpr int kRounds = 5;

constexpr const char* kViewForm = "+x|-x|+y|-y|+z|-z|iso";

Vec3 ReadView(const std::string& text)
{
  if (text == "iso")
  {
    return Vec3(1.0);
  }
  const std::size_t axis = text.size() == 2 ? std::string("xyz").find(text[1]) : std::string::npos;
  if (axis == std::string::npos || (text[0] != '+' && text[0] != '-'))
  {
    Refuse("--view", text, kViewForm);
  }
  Vec3 from(0.0);
  from[static_cast<int>(axis)] = text[0] == '+' ? 1.0 : -1.0;
  return from;
}
} // namespace

void CameraOptions::AddTo(CLI::App& command)
{
  const char* group = "Camera (default: the whole data set, along the first surface's normal)";
  AddedOption view = AddRead(
    command, "--view", [this](const std::string& text) { From = ReadView(text); }, kViewForm,
    "See the whole data set from there: from the side where x is largest, ..., or from (1, 1, 1)");
  AddedOption position =
    AddNumbers(command, "--camera-position", Position, 3, "x,y,z", "Where the camera stands");
  AddedOption focus =
    AddNumbers(command, "--focal-point", FocalPoint, 3, "x,y,z", "What it looks at");
  AddNumbers(command, "--view-up", ViewUp, 3, "x,y,z", "What is up in the image").Group(group);
  AddedOption angle = AddNumber(command, "--view-angle", ViewAngle, "DEGREES",
    "Vertical angle of a perspective view (default: 30)");
  AddedOption scale = AddNumber(command, "--parallel-scale", ParallelScale, "LENGTH",
    "Parallel view; half of the image's height in world units");
  view.Excludes(position).Group(group);
  position.Needs(focus).Group(group);
  focus.Needs(position).Group(group);
  angle.Excludes(scale).Group(group);
  scale.Group(group);
}

void CameraOptions::Check() const
{
  if (ViewAngle && !(*ViewAngle > 0.0 && *ViewAngle < 180.0))
  {
    throw UsageError("--view-angle: expected degrees above 0 and below 180");
  }
  if (!ViewUp.empty() && glm::length(ToVec3(ViewUp)) == 0.0)
  {
    throw UsageError("--view-up is zero; give a direction");
  }
  // Any box and direction that the view-up given is not parallel to will do.
  const bool upAlongZ = !ViewUp.empty() && ViewUp[0] == 0.0 && ViewUp[1] == 0.0;
  (void)Make(
    { Vec3(-1.0), Vec3(1.0) }, upAlongZ ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 0.0, 1.0), { 1, 1, {} });
}

CameraView CameraOptions::Make(
  const Box3& bounds, const Vec3& surfaceNormal, const ImageSize& size) const
{
  const Vec3 normal = From.value_or(surfaceNormal);
  const bool parallel = ParallelScale.has_value();
  CameraView view;
  try
  {
    if (Position.empty())
    {
      const Vec3 up = ViewUp.empty() ? UsualUp(normal) : ToVec3(ViewUp);
      view =
        ViewOfBox(bounds, normal, size.width, size.height, up, parallel, ViewAngle.value_or(30.0));
      // The view of a box takes another where that is nearly its normal.
      view.viewUp = ViewUp.empty() ? view.viewUp : up;
    }
    else
    {
      view.position = ToVec3(Position);
      view.focalPoint = ToVec3(FocalPoint);
      view.viewUp = ViewUp.empty() ? UsualUp(view.position - view.focalPoint) : ToVec3(ViewUp);
      view.parallel = parallel;
      view.viewAngle = ViewAngle.value_or(view.viewAngle);
    }
    view.parallelScale = ParallelScale.value_or(view.parallelScale);
    // As a vtkCamera would hold it, so that the mapper's rays for the same options are these.
    view = AsHeld(view);
    (void)Camera(view, size.width, size.height);
  }
  catch (const Error& error)
  {
    throw UsageError(error.what());
  }
  return view;
}

CameraView CameraOptions::FitTo(
  std::span<const Vec3> points, const CameraView& all, const ImageSize& size) const
{
  if (points.empty())
  {
    return all;
  }
  const Vec3 towards = glm::normalize(all.position - all.focalPoint);
  const Vec3 right = glm::normalize(glm::cross(all.viewUp, towards));
  const Vec3 up = glm::cross(towards, right);
  const double aspect = static_cast<double>(size.width) / size.height;
  const double slope = kFilled * std::tan(0.5 * glm::radians(all.viewAngle));
  CameraView view = all;
  double distance = glm::distance(all.position, all.focalPoint);
  // The middle of what is seen is not that of the points where near ones look larger: each round
  // moves there, and as near as can be.
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
    // Of a single point, or a line that is seen from its end, nothing is learnt.
    if (!(view.parallelScale > 1e-6 * all.parallelScale))
    {
      return all;
    }
  }
  view.position = view.focalPoint + distance * towards;
  view.parallelScale = ParallelScale.value_or(view.parallelScale);
  view = AsHeld(view);
  try
  {
    (void)Camera(view, size.width, size.height);
  }
  catch (const Error&)
  {
    // So near that rounding leaves no direction.
    return all;
  }
  return view;
}
} // namespace pixelexact
