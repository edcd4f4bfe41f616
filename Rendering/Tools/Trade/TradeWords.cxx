// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeWords.h"

#include "Base/Report.h"
#include "Picture/RenderReport.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace pixelexact
{
namespace
{
constexpr std::array<std::string_view, 12> kOwn{ "--resolutions", "--grids", "--levels",
  "--truncate-orders", "--repeat", "--bins", "--share", "--timed", "--target-error",
  "--target-time", "--output", "-o" };

std::string MarginText(const Recommendation& recommended)
{
  return std::isinf(recommended.margin)
    ? "no error at all"
    : fmt::format("{} times within what was asked for", Short(recommended.margin, 3));
}

std::string HasText(const TradeRow& row, const TradeTarget& target, const TradeFacts& facts)
{
  return fmt::format("{} of the range in {} % of the pixels, {} s {}",
    Short(Relative(row.errors.atShare, facts.range), 3), Short(100.0 * facts.share),
    Short(target.ofNext ? row.next.Median() : row.first.Median(), 3),
    target.ofNext ? "for a later cut" : "to the first picture");
}

/// The command that makes the picture of an exact setting.
std::string CommandOf(const TradeSetting& setting, std::vector<std::string> words)
{
  constexpr std::string_view kStride = "exact-stride-";
  if (setting.name == "exact-float")
  {
    words.insert(words.end(), { "--precision", "float" });
  }
  else if (setting.name.starts_with(kStride))
  {
    words.insert(words.end(), { "--stride", setting.name.substr(kStride.size()) });
  }
  else if (setting.order)
  {
    words.insert(words.end(), { "--truncate-order", fmt::to_string(*setting.order) });
  }
  return RepeatedCommand{ words, {} }.Text();
}
} // namespace

std::vector<std::string> SceneWords(
  const std::vector<std::string>& words, const std::vector<std::string>& chosen)
{
  std::vector<std::string> scene{ "render" };
  for (std::size_t k = 1; k < words.size(); ++k)
  {
    const std::string name = words[k].substr(0, words[k].find('='));
    if (name == "--json")
    {
      continue;
    }
    if (std::ranges::find(kOwn, name) == kOwn.end())
    {
      scene.push_back(words[k]);
    }
    else if (name == words[k])
    {
      ++k; // and its value
    }
  }
  scene.insert(scene.end(), chosen.begin(), chosen.end());
  return scene;
}

std::string Describe(const Recommendation& recommended, const TradeTarget& target,
  const TradeFacts& facts, const std::vector<std::string>& sceneWords)
{
  if (recommended.row == nullptr)
  {
    return recommended.nearest == nullptr
      ? "no setting was measured"
      : fmt::format("no setting meets it; nearest is {}: {}", recommended.nearest->setting.name,
          HasText(*recommended.nearest, target, facts));
  }
  const TradeRow& row = *recommended.row;
  std::string text = fmt::format(
    "{}: {}; {}", row.setting.name, HasText(row, target, facts), MarginText(recommended));
  if (row.setting.family == TradeFamily::Exact)
  {
    text += "\n" + CommandOf(row.setting, sceneWords);
  }
  else if (!facts.script.empty())
  {
    text += "\npython3 " + facts.script + " cut.vtp";
  }
  return text;
}
} // namespace pixelexact
