// SPDX-License-Identifier: BSD-3-Clause
#include "Input/Input.h"

#include "Base/Numbers.h"

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
}
} // namespace pixelexact
