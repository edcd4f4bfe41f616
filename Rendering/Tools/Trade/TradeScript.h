// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/TradeRun.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// A Python program that makes the linear surface of a setting with VTK and the package pixelexact
/// and writes it to the .vtp file that it is told. Empty where the inputs are of a kind or have a
/// time that it would not read alike, and of settings with VTK's Gradient filter.
[[nodiscard]] std::string ScriptOf(
  const TradeScene& scene, const TradeSetting& setting, const std::vector<std::string>& files);
} // namespace pixelexact
