// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/Recommendation.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace pixelexact
{
Recommendation Recommend(
  const std::vector<TradeRow>& rows, const TradeTarget& target, const std::array<double, 2>& range)
{
  const auto seconds = [&target](const TradeRow& row)
  { return target.ofNext ? row.next.Median() : row.first.Median(); };
  const auto error = [&range](const TradeRow& row) { return Relative(row.errors.atShare, range); };
  std::vector<const TradeRow*> all;
  for (const TradeRow& row : rows)
  {
    if (row.IsThere() && HasOwnValues(row.setting))
    {
      all.push_back(&row);
    }
  }
  const auto byTime = [&](const TradeRow* a, const TradeRow* b)
  { return std::pair(seconds(*a), error(*a)) < std::pair(seconds(*b), error(*b)); };
  const auto byError = [&](const TradeRow* a, const TradeRow* b)
  { return std::pair(error(*a), seconds(*a)) < std::pair(error(*b), seconds(*b)); };
  std::vector<const TradeRow*> good;
  std::ranges::copy_if(all, std::back_inserter(good),
    [&](const TradeRow* row)
    {
      return (!target.error || error(*row) <= *target.error) &&
        (!target.seconds || seconds(*row) <= *target.seconds);
    });
  Recommendation result;
  if (!good.empty())
  {
    if (target.error)
    {
      const double most = kAlikeTimes * seconds(**std::ranges::min_element(good, byTime));
      std::erase_if(good, [&](const TradeRow* row) { return seconds(*row) > most; });
    }
    result.row = *std::ranges::min_element(good, byError);
    const double wanted = target.error ? *target.error : *target.seconds;
    const double has = target.error ? error(*result.row) : seconds(*result.row);
    result.margin = has > 0.0 ? wanted / has : std::numeric_limits<double>::infinity();
    return result;
  }
  // The nearest, or the fastest.
  if (!all.empty())
  {
    const bool byErrors = target.error && !target.seconds;
    result.nearest = *std::ranges::min_element(all,
      [&](const TradeRow* a, const TradeRow* b)
      { return byErrors ? byError(a, b) : byTime(a, b); });
  }
  return result;
}
} // namespace pixelexact
