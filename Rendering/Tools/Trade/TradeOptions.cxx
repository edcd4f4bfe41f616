// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeOptions.h"

#include "Base/Options.h"

#include <set>

namespace pixelexact
{
void TradeOptions::AddTo(CLI::App& command)
{
  Bind(command, "--resolutions", resolutions_);
  Bind(command, "--grids", grids_);
  Bind(command, "--levels", levels_);
  Bind(command, "--truncate-orders", orders_);
  Bind(command, "--repeat", repeat_);
  Bind(command, "--bins", bins_);
  Bind(command, "--share", Percent);
  Bind(command, "--timed", [this](const std::string& text) { Next = text == "next"; });
  Bind(command, "--target-error", TargetError);
  Bind(command, "--target-time", TargetTime);
  Bind(command, "--output", output_);
}

std::vector<int> TradeOptions::Resolutions(bool ofPlane) const
{
  return resolutions_.value_or(
    ofPlane ? std::vector{ 64, 128, 256, 512, 1024 } : std::vector{ 32, 64, 128, 256 });
}

std::vector<int> TradeOptions::Orders(int ofField) const
{
  if (orders_)
  {
    return *orders_;
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

std::optional<TradeTarget> TradeOptions::Target() const
{
  return TargetError || TargetTime ? std::optional(TradeTarget{ TargetError, TargetTime, Next })
                                   : std::nullopt;
}
} // namespace pixelexact
