// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/DifferenceOptions.h"

#include "Base/Command.h"
#include "Base/Numbers.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace pixelexact
{
namespace
{
constexpr const char* kWith = "--with";
} // namespace

void DifferenceOptions::AddTo(CLI::App& command)
{
  const char* group = "Two solutions";
  const AddedOption with = AddWordGroups(command, kWith, Groups, "FILE...",
    "Another solution, files as INPUT's: the difference INPUT less this one is shown, both "
    "evaluated exactly at each pixel's point; fields alone go with INPUT's mesh. Given several "
    "times: each, and how they converge to INPUT")
                             .Group(group);
  AddText(command, "--with-field", TheField, "NAME",
    "Its field (default: of the same name, else its only one)")
    .Needs(with)
    .Group(group);
  const AddedOption step = AddRead(
    command, "--with-time-step",
    [this](const std::string& text)
    {
      int number = 0;
      if (!ParseInteger(text, number) || number < 0)
      {
        Refuse("--with-time-step", text, "the number of a step, counted from 0");
      }
      Step = number;
    },
    "N", "Its time step, counted from 0 (default: the first)")
                             .Needs(with)
                             .Group(group);
  AddNumber(command, "--with-time", Time, "T", "Its time; of the steps the nearest one")
    .Excludes(step)
    .Needs(with)
    .Group(group);
  AddText(command, "--buffers", TheBuffers, "OUT.vti",
    "Also write what was found at each pixel: the difference as Value with its bounds, First and "
    "Second, and Side: 0 nothing, 1 both have a value, 2 unknown, 3 only INPUT, 4 only the other")
    .Needs(with)
    .Group(group);
  TheFigure.AddTo(command);
  TheFont.AddTo(command);
}

void DifferenceOptions::Check(const CLI::App& command, const ImageSize& size) const
{
  constexpr std::array<std::string_view, 10> kOfLinearPictures{ "--resolutions", "--grids",
    "--levels", "--truncate-orders", "--repeat", "--bins", "--share", "--timed", "--target-error",
    "--target-time" };
  constexpr std::array<std::string_view, 4> kOfFigures{ "--figure", "--title", "--font-size",
    "--font" };
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
    if (!IsAsked() && is(kOfFigures))
    {
      throw UsageError(name + " has no effect on a comparison without --with; leave it out");
    }
  }
  if (Groups.size() > 1 && !TheBuffers.empty())
  {
    throw UsageError("--buffers: there are several differences; give --with once");
  }
  if (IsAsked())
  {
    TheFont.Check();
    TheFigure.Check(size);
  }
}

std::vector<InputRequest> DifferenceOptions::Requests(const InputRequest& first) const
{
  std::vector<InputRequest> requests;
  for (const std::vector<std::string>& files : Groups)
  {
    InputRequest request = first;
    request.step = Step;
    request.time = Time;
    request.files = files;
    request.truncateOrder.reset();
    if (std::ranges::all_of(files, HoldsFieldsAlone))
    {
      request.files.clear();
      std::ranges::copy_if(first.files, std::back_inserter(request.files),
        [](const std::string& file) { return !HoldsFieldsAlone(file); });
      request.files.insert(request.files.end(), files.begin(), files.end());
    }
    requests.push_back(std::move(request));
  }
  return requests;
}
} // namespace pixelexact
