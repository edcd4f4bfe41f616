// SPDX-License-Identifier: BSD-3-Clause
#include "Input/Input.h"

#include "Base/Numbers.h"

#include <cmath>

// Options of INPUT.
namespace pixelexact
{
namespace
{
int ParseStep(const std::string& text, bool mayBeAll)
{
  int number = 0;
  if (!ParseInteger(text, number) || number < 0)
  {
    Refuse("--time-step", text,
      mayBeAll
        ? "the number of a step, counted from 0, or all (info names the times)"
        : "the number of one step, counted from 0 (call once for each; info names the times)");
  }
  return number;
}

} // namespace

void ReadWarp(const char* option, const std::string& text, WarpRequest& warp)
{
  const std::size_t at = text.rfind('=');
  warp.field = text.substr(0, at);
  if (warp.field.empty() ||
    (at != std::string::npos &&
      !(ParseNumber(text.substr(at + 1), warp.scale) && std::isfinite(warp.scale))))
  {
    Refuse(option, text, "FIELD or FIELD=SCALE with a finite number, such as displacement=10");
  }
}

void InputRequest::AddTo(CLI::App& command)
{
  Bind(command, "INPUT", files);
  Bind(command, "--time-step",
    [this](const std::string& text)
    {
      allSteps = mayBeAll && text == "all";
      step = allSteps ? std::nullopt : std::optional(ParseStep(text, mayBeAll));
    });
  Bind(command, "--time", time);
  Bind(command, "--nodes", [this](const std::string& text) { gaussLobatto = text == "gll"; });
  Bind(command, "--mirrored-wedges", mirroredWedges);
  Bind(command, "--surface-elements", surfaceElements);
  Bind(command, "--warp",
    [this](const std::string& text) { ReadWarp("--warp", text, warp.emplace()); });
  Bind(command, "--warp-direction", warpDirection);
  Bind(command, "--phase", phase);
}

WarpRequest InputRequest::WarpBy(const std::string& field, double scale) const
{
  WarpRequest request{ field, scale, {} };
  if (!warpDirection.empty())
  {
    request.direction = Vec3(warpDirection[0], warpDirection[1], warpDirection[2]);
  }
  return request;
}
} // namespace pixelexact
