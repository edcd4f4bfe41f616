// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/Recommendation.h"
#include "Trade/TradeReport.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// The words of compare's command line that describe the scene, for render.
[[nodiscard]] std::vector<std::string> SceneWords(
  const std::vector<std::string>& words, const std::vector<std::string>& chosen);

/// The recommended setting, its margin, and the command that makes its picture; if none meets the
/// target, a text that states this and names the nearest setting.
[[nodiscard]] std::string Describe(const Recommendation& recommended, const TradeTarget& target,
  const TradeFacts& facts, const std::vector<std::string>& sceneWords);
} // namespace pixelexact
