// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/CameraOptions.h"

#include "Base/Command.h"
#include "Base/Options.h"

#include "Core/Base/Error.h"
#include "Views/FittedView.h"
#include "Views/VtkCamera.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace pixelexact
{
namespace
{
Vec3 ToVec3(const std::vector<double>& v)
{
  return { v[0], v[1], v[2] };
}

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
  Bind(command, "--view", [this](const std::string& text) { From = ReadView(text); });
  Bind(command, "--camera-position", Position);
  Bind(command, "--focal-point", FocalPoint);
  Bind(command, "--view-up", ViewUp);
  Bind(command, "--view-angle", ViewAngle);
  Bind(command, "--parallel-scale", ParallelScale);
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
    // Rounds the view as a vtkCamera does, so that the mapper's rays for the same options are
    // equal.
    view = AsHeld(view);
    (void)Camera(view, size.width, size.height);
  }
  catch (const Error& error)
  {
    throw UsageError(error.what());
  }
  return view;
}
} // namespace pixelexact
