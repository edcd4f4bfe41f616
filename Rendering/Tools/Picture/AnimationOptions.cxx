// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/AnimationOptions.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Input/Input.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <string_view>

namespace pixelexact
{
namespace
{
constexpr const char* kSweepForm = "AXIS=FROM:TO:N";
constexpr const char* kTurnForm = "DEGREES:N";

bool ReadFrames(const std::string& text, int& frames)
{
  return ParseInteger(text, frames) && frames >= 1 && frames <= AnimationOptions::kMaxFrames;
}

/// About an axis of unit length (O. Rodrigues, 1840).
Vec3 Rotated(const Vec3& v, const Vec3& axis, double angle)
{
  return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v) +
    (1.0 - std::cos(angle)) * glm::dot(axis, v) * axis;
}
} // namespace

void AnimationOptions::AddTo(CLI::App& command)
{
  Command = &command;
  Bind(command, "--sweep",
    [this](const std::string& text)
    {
      Swept sweep{};
      const std::vector<std::string> parts =
        SplitAt(text.size() > 2 ? text.substr(2) : std::string(), ':');
      const auto read = [](const std::string& part, double& at, bool& percent)
      {
        percent = part.ends_with('%');
        return ParseNumber(std::string_view(part).substr(0, part.size() - (percent ? 1 : 0)), at) &&
          std::isfinite(at) && (!percent || (at >= 0.0 && at <= 100.0));
      };
      bool first = false;
      bool last = false;
      if (parts.size() != 3 || std::string_view("xyz").find(text[0]) == std::string_view::npos ||
        text[1] != '=' || !read(parts[0], sweep.from, first) || !read(parts[1], sweep.to, last) ||
        first != last || !ReadFrames(parts[2], sweep.frames))
      {
        Refuse("--sweep", text,
          std::string(kSweepForm) + ", such as z=0:1:50, or z=5%:95%:50 of the mesh's box");
      }
      sweep.axis = text[0];
      sweep.inPercent = first;
      Sweep = sweep;
    });
  Bind(command, "--turn",
    [this](const std::string& text)
    {
      const std::vector<std::string> parts = SplitAt(text, ':');
      double degrees = 0.0;
      int frames = 0;
      if (parts.size() != 2 || !ParseNumber(parts[0], degrees) || !std::isfinite(degrees) ||
        !ReadFrames(parts[1], frames))
      {
        Refuse("--turn", text, std::string(kTurnForm) + ", such as 360:90");
      }
      Turn = { degrees, frames };
    });
  Bind(command, "--fps", Rate);
  Bind(command, "--resume", Resume);
}

bool AnimationOptions::IsAsked(const InputRequest& input) const
{
  return Sweep || Turn || input.allSteps;
}

void AnimationOptions::Check(const InputRequest& input) const
{
  if (Sweep && Turn && Sweep->frames != Turn->frames)
  {
    throw UsageError(fmt::format(
      "--sweep has {} pictures and --turn {}; give both as many", Sweep->frames, Turn->frames));
  }
  for (const char* option : { "--fps", "--resume" })
  {
    if (!IsAsked(input) && IsGiven(*Command, option))
    {
      throw UsageError(std::string(option) +
        " has no effect on one picture; give --sweep, --turn or --time-step all");
    }
  }
}

std::optional<int> AnimationOptions::Frames() const
{
  return Sweep ? std::optional(Sweep->frames) : Turn ? std::optional(Turn->frames) : std::nullopt;
}

PlaneChoice AnimationOptions::PlaneAt(int frame) const
{
  const double part = Sweep->frames > 1 ? static_cast<double>(frame) / (Sweep->frames - 1) : 0.0;
  return PlaneChoice::Read(fmt::format(
    "{}={}{}", Sweep->axis, std::lerp(Sweep->from, Sweep->to, part), Sweep->inPercent ? "%" : ""));
}

CameraView AnimationOptions::ViewAt(int frame, const CameraView& first, const Vec3& pivot) const
{
  if (!Turn)
  {
    return first;
  }
  const Vec3 axis = glm::normalize(first.viewUp);
  const double angle = glm::radians(Turn->degrees) * frame / Turn->frames;
  CameraView view = first;
  view.position = pivot + Rotated(first.position - pivot, axis, angle);
  view.focalPoint = pivot + Rotated(first.focalPoint - pivot, axis, angle);
  return view;
}
} // namespace pixelexact
