// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/TradeRun.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// A Python program that makes the linear surface of a setting with VTK and the package pixelexact,
/// and writes it to the .vtp file that its argument names. Empty where its input would differ
/// (kinds of files, times), and for settings with VTK's Gradient filter.
[[nodiscard]] std::string ScriptOf(
  const TradeScene& scene, const TradeSetting& setting, const std::vector<std::string>& files);
} // namespace pixelexact
