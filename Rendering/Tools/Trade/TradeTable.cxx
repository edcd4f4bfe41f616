// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeTable.h"

#include "Base/Options.h"
#include "Base/Report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace pixelexact
{
nlohmann::ordered_json ToJson(const TradeRow& row, const std::array<double, 2>& range)
{
  nlohmann::ordered_json object{ { "setting", row.setting.name } };
  if (IsOfGradientFilter(row.setting.family))
  {
    object["method"] = kGradientMethod;
  }
  if (!row.IsThere())
  {
    object["refused"] = row.refused;
    return object;
  }
  const PictureErrors& e = row.errors;
  object.update({ { "first_seconds", row.first.Median() }, { "first_ratio", row.first.Ratio() },
    { "next_seconds", row.next.Median() }, { "next_ratio", row.next.Ratio() },
    { "peak_bytes", row.bytes >= 0.0 ? nlohmann::ordered_json(row.bytes) : nullptr },
    { "triangles", row.triangles }, { "shown", e.shown }, { "missing", e.missing },
    { "invented", e.invented }, { "unknown", row.unknown },
    { "largest_error", Relative(e.largest, range) }, { "mean_error", Relative(e.mean, range) },
    { "share_error", Relative(e.atShare, range) }, { "wrong_colors", e.wrongBin } });
  if (row.proven)
  {
    object["proven_change"] = Relative(*row.proven, range);
  }
  if (e.hasContours)
  {
    object["contours"] = { { "pixels", e.contourPixels }, { "missed", e.contourMissed },
      { "displaced", e.contourDisplaced }, { "invented", e.contourInvented },
      { "farthest", e.contourFarthest } };
  }
  return object;
}

void PrintRows(const std::vector<TradeRow>& rows, const TradeFacts& facts)
{
  Table table;
  table.Row("setting", "{:>10} {:>8} {:>10} {:>8} {:>9} {:>9} {:>9} {:>9} {:>8} {:>9}", "first, s",
    "ratio", "next, s", "ratio", "MB", "mean", "share", "largest", "missing", "proven");
  for (const TradeRow& row : rows)
  {
    if (!row.IsThere())
    {
      table.Row(row.setting.name, row.refused);
      continue;
    }
    const auto error = [&facts](double value) { return Short(Relative(value, facts.range), 3); };
    table.Row(row.setting.name, "{:>10} {:>8} {:>10} {:>8} {:>9} {:>9} {:>9} {:>9} {:>8} {:>9}",
      Short(row.first.Median(), 3), Short(row.first.Ratio(), 3), Short(row.next.Median(), 3),
      Short(row.next.Ratio(), 3), row.bytes >= 0.0 ? Short(row.bytes * 1e-6, 3) : "-",
      error(row.errors.mean), error(row.errors.atShare), error(row.errors.largest),
      row.errors.missing, row.proven ? error(*row.proven) : "-");
  }
  if (std::ranges::any_of(rows,
        [](const TradeRow& row)
        { return row.IsThere() && IsOfGradientFilter(row.setting.family); }))
  {
    table.Row("gradient-...", kGradientMethod);
  }
  for (const TradeOrder& order : OrdersOf(rows, facts.range))
  {
    table.Row(fmt::format("order of {}", Name(order.family)), "{:.2f}; {:.2f} at the end",
      order.overall, order.last);
  }
  if (!facts.recommendation.empty())
  {
    std::string name = "recommended";
    for (const std::string& line : SplitAt(facts.recommendation, '\n'))
    {
      table.Row(name, line);
      name.clear();
    }
  }
  table.Print();
}
} // namespace pixelexact
