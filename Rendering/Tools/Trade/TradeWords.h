// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trade/Recommendation.h"
#include "Trade/TradeReport.h"

#include <string>
#include <vector>

namespace pixelexact
{
/// Of compare's command line the words that make the scene, for render.
[[nodiscard]] std::vector<std::string> SceneWords(
  const std::vector<std::string>& words, const std::vector<std::string>& chosen);

/// The recommended setting, its margin, and what makes its picture; or that there is none, and what
/// comes nearest.
[[nodiscard]] std::string Describe(const Recommendation& recommended, const TradeTarget& target,
  const TradeFacts& facts, const std::vector<std::string>& sceneWords);
} // namespace pixelexact
