// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/DifferenceOptions.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Settings.h"
#include "Input/OtherInputs.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace pixelexact
{

void DifferenceOptions::AddTo(CLI::App& command)
{
  Bind(command, "--with", Groups);
  Bind(command, "--with-field", field_);
  Bind(command, "--with-time-step",
    [this](const std::string& text)
    {
      int number = 0;
      if (!ParseInteger(text, number) || number < 0)
      {
        Refuse("--with-time-step", text, "the number of a step, counted from 0");
      }
      Step = number;
    });
  Bind(command, "--with-time", Time);
  Bind(command, "--buffers", buffers_);
  figure_.AddTo(command);
  font_.AddTo(command);
}

void DifferenceOptions::Check(const CLI::App& command, const ImageSize& size) const
{
  constexpr std::array<std::string_view, 10> kOfLinearPictures{ "--resolutions", "--grids",
    "--levels", "--truncate-orders", "--repeat", "--bins", "--share", "--timed", "--target-error",
    "--target-time" };
  const std::string_view figures = FindSetting("compare", "--figure")->group;
  for (const std::string& name : OptionsGiven(command))
  {
    const auto is = [&name](const auto& names)
    { return std::ranges::find(names, name) != names.end(); };
    if (IsAsked() && is(kOfLinearPictures))
    {
      throw UsageError(
        name + " is of linear pictures, and --with compares solutions; leave one out");
    }
    if (IsAsked() && name.starts_with("--contours"))
    {
      throw UsageError(name + ": differences have no proven contours; leave it out, or --with");
    }
    if (!IsAsked() && FindSetting("compare", name)->group == figures)
    {
      throw UsageError(name + " has no effect on a comparison without --with; leave it out");
    }
  }
  if (Groups.size() > 1 && !buffers_.empty())
  {
    throw UsageError("--buffers: there are several differences; give --with once");
  }
  if (IsAsked())
  {
    font_.Check();
    figure_.Check(size);
  }
}

std::vector<InputRequest> DifferenceOptions::Requests(const InputRequest& first) const
{
  std::vector<InputRequest> requests = RequestsWith(first, Groups);
  for (InputRequest& request : requests)
  {
    request.allSteps = false;
    request.step = Step;
    request.time = Time;
    request.truncateOrder.reset();
  }
  return requests;
}
} // namespace pixelexact
