// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/AnimationOptions.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Input/Input.h"
#include "Picture/CameraMoves.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
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
} // namespace

void AnimationOptions::ReadSweep(const std::string& text)
{
  constexpr std::string_view kWarp = "warp=";
  constexpr std::string_view kPhase = "phase=";
  const bool isWarp = text.starts_with(kWarp);
  const bool isPhase = text.starts_with(kPhase);
  const std::size_t begin = isWarp ? kWarp.size() : isPhase ? kPhase.size() : 2;
  const std::vector<std::string> parts =
    SplitAt(text.size() > 2 ? text.substr(begin) : std::string(), ':');
  const auto read = [isNumber = isWarp || isPhase](
                      const std::string& part, double& at, bool& percent)
  {
    percent = !isNumber && part.ends_with('%');
    return ParseNumber(std::string_view(part).substr(0, part.size() - (percent ? 1 : 0)), at) &&
      std::isfinite(at) && (!percent || (at >= 0.0 && at <= 100.0));
  };
  Swept sweep{};
  bool first = false;
  bool last = false;
  const bool isAxis = text.size() > 2 &&
    std::string_view("xyz").find(text[0]) != std::string_view::npos && text[1] == '=';
  if (parts.size() != 3 || !(isWarp || isPhase || isAxis) || !read(parts[0], sweep.from, first) ||
    !read(parts[1], sweep.to, last) || first != last || !ReadFrames(parts[2], sweep.frames))
  {
    Refuse("--sweep", text,
      std::string(kSweepForm) +
        ", such as z=0:1:50, z=5%:95%:50 of the mesh's box, warp=0:10:50 of --warp, or "
        "phase=0:345:24 in degrees");
  }
  if (isWarp || isPhase)
  {
    (isWarp ? Deformation : Phase) = { sweep.from, sweep.to, sweep.frames };
    return;
  }
  sweep.axis = text[0];
  sweep.inPercent = first;
  Sweep = sweep;
}

void AnimationOptions::AddTo(CLI::App& command)
{
  Command = &command;
  Bind(command, "--sweep", [this](const std::string& text) { ReadSweep(text); });
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
  return Sweep || Deformation || Phase || Turn || input.allSteps;
}

void AnimationOptions::Check(const InputRequest& input) const
{
  const std::optional<int> swept = Sweep ? std::optional(Sweep->frames)
    : Deformation                        ? std::optional(Deformation->frames)
    : Phase                              ? std::optional(Phase->frames)
                                         : std::nullopt;
  if (swept && Turn && *swept != Turn->frames)
  {
    throw UsageError(fmt::format(
      "--sweep has {} pictures and --turn {}; give both as many", *swept, Turn->frames));
  }
  if (Deformation && !input.warp)
  {
    throw UsageError("--sweep warp=FROM:TO:N needs the displacement; give --warp FIELD");
  }
  if (Phase && input.phase)
  {
    throw UsageError("--sweep phase=FROM:TO:N has the phases; leave out --phase");
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
  return Sweep    ? std::optional(Sweep->frames)
    : Deformation ? std::optional(Deformation->frames)
    : Phase       ? std::optional(Phase->frames)
    : Turn        ? std::optional(Turn->frames)
                  : std::nullopt;
}

double AnimationOptions::Numbers::At(int frame) const
{
  return std::lerp(from, to, static_cast<double>(frame) / std::max(frames - 1, 1));
}

void AnimationOptions::Apply(int frame, InputRequest& input) const
{
  if (Deformation)
  {
    input.warp->scale = Deformation->At(frame);
  }
  if (Phase)
  {
    input.phase = Phase->At(frame);
  }
}

double AnimationOptions::LargestScale() const
{
  return std::fabs(Deformation->from) > std::fabs(Deformation->to) ? Deformation->from
                                                                   : Deformation->to;
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
