// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/TradeReport.h"
#include "Trade/TradeRows.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

// Printed tables and JSON of a comparison.
namespace pixelexact
{
[[nodiscard]] nlohmann::ordered_json ToJson(
  const TradeRow& row, const std::array<double, 2>& range);

void PrintRows(const std::vector<TradeRow>& rows, const TradeFacts& facts);
} // namespace pixelexact
