// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeOptions.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Options.h"

#include "Core/Basis/Space.h"

#include <algorithm>
#include <set>

namespace pixelexact
{
namespace
{
/// Integers between commas, or none; ascending, each once.
template <class Numbers>
void AddList(CLI::App& command, const std::string& name, Numbers& given, std::array<int, 2> limits,
  const std::string& help)
{
  AddRead(
    command, name,
    [&given, name, limits](const std::string& text)
    {
      std::vector<int> numbers;
      for (const std::string& part :
        text == "none" ? std::vector<std::string>() : SplitAt(text, ','))
      {
        int number = 0;
        if (!ParseInteger(part, number) || number < limits[0] || number > limits[1])
        {
          Refuse(name, text,
            "'none' or integers from " + std::to_string(limits[0]) + " to " +
              std::to_string(limits[1]) + " with commas between them");
        }
        numbers.push_back(number);
      }
      std::ranges::sort(numbers);
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
      given = std::move(numbers);
    },
    "none|n1,n2,...", help)
    .Group("Comparison");
}
} // namespace

void TradeOptions::AddTo(CLI::App& command)
{
  const char* group = "Comparison";
  AddList(command, "--resolutions", TheResolutions, { 1, 1000000 },
    "Triangulated cuts: squares of a plane along its longer side, or samples along the mesh's box "
    "(default: 64,128,256,512,1024; of surfaces that are no planes 32,64,128,256)");
  AddList(command, "--grids", TheGrids, { 2, 100000 },
    "Regular grids over the volume: nodes along its longest side (default: 16,32,64,128)");
  AddList(command, "--levels", TheLevels, { 0, 5 },
    "Elements cut into linear cells: levels, at l each edge becomes 2^l (default: 0,1,2,3)");
  AddList(command, "--truncate-orders", TheOrders, { 0, kMaxOrder },
    "The exact picture of the field truncated to these orders (default: half of its order, two and "
    "one below it)");
  AddInteger(command, "--repeat", TheRepeat, 1, 10000, "N",
    "How often each is timed, turn by turn (default: 3)")
    .Group(group);
  AddInteger(command, "--bins", TheBins, 1, 1000000, "N",
    "Colours of the map, for pixels that get a wrong one (default: 256)")
    .Group(group);
  AddNumber(command, "--share", Percent, "PERCENT",
    "Pixels whose error --target-error is about; one without a value is infinitely far off "
    "(default: 99)")
    .Group(group);
  AddChoice(
    command, "--timed", [this](const std::string& text) { Next = text == "next"; },
    { "first", "next" },
    "Plot and ask for the time of a first picture (default), or of the next cut of the same data")
    .Group(group);
  AddNumber(command, "--target-error", TargetError, "E",
    "Name the fastest setting that is off by no more than E of the range")
    .Group(group);
  AddNumber(command, "--target-time", TargetTime, "SECONDS",
    "Name the most accurate setting that takes no longer; with --target-error both are to hold")
    .Group(group);
  AddText(command, "-o,--output", TheOutput, "FOLDER|IMAGE",
    "Folder for trade.csv, report.html and the pictures (default: named after the input, in the "
    "current folder); with --with the picture of the difference, of several a folder")
    .Group(group);
}

std::vector<int> TradeOptions::Resolutions(bool ofPlane) const
{
  return TheResolutions.value_or(
    ofPlane ? std::vector{ 64, 128, 256, 512, 1024 } : std::vector{ 32, 64, 128, 256 });
}

std::vector<int> TradeOptions::Orders(int ofField) const
{
  if (TheOrders)
  {
    return *TheOrders;
  }
  std::set<int> orders;
  for (const int order : { ofField / 2, ofField - 2, ofField - 1 })
  {
    if (order > 0)
    {
      orders.insert(order);
    }
  }
  return { orders.begin(), orders.end() };
}

void TradeOptions::Check() const
{
  if (!(Share() > 0.0) || Share() > 1.0)
  {
    throw UsageError("--share: between 0 and 100 percent, above 0");
  }
  if ((TargetError && !(*TargetError >= 0.0)) || (TargetTime && !(*TargetTime > 0.0)))
  {
    throw UsageError(TargetError && !(*TargetError >= 0.0)
        ? "--target-error: an error is not below 0"
        : "--target-time: a time is above 0");
  }
}

std::optional<TradeTarget> TradeOptions::Target() const
{
  return TargetError || TargetTime ? std::optional(TradeTarget{ TargetError, TargetTime, Next })
                                   : std::nullopt;
}
} // namespace pixelexact
