// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Report.h"
#include "Drawing/Plot.h"
#include "Trade/TradeReport.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr std::array kFamilies{ TradeFamily::Exact, TradeFamily::Cut, TradeFamily::Resample,
  TradeFamily::Subdivide, TradeFamily::Cells, TradeFamily::Gradient, TradeFamily::GradientCells };

Rgba ColorOf(TradeFamily family)
{
  switch (family)
  {
    case TradeFamily::Exact:
      return { 200, 30, 30, 255 };
    case TradeFamily::Cut:
      return { 20, 90, 180, 255 };
    case TradeFamily::Resample:
      return { 200, 130, 0, 255 };
    case TradeFamily::Subdivide:
      return { 20, 140, 70, 255 };
    case TradeFamily::Gradient:
      return { 20, 20, 20, 255 };
    case TradeFamily::GradientCells:
      return { 130, 90, 50, 255 };
    default:
      return { 120, 60, 160, 255 };
  }
}

/// The part of a setting's name that distinguishes it from others of its family.
std::string LabelOf(const TradeSetting& setting)
{
  const std::string family = Name(setting.family);
  return setting.name.starts_with(family + "-") ? setting.name.substr(family.size() + 1)
                                                : setting.name;
}
} // namespace

std::vector<std::uint8_t> DrawPareto(
  const std::vector<TradeRow>& rows, const TradeFacts& facts, int width, int height)
{
  Plot plot;
  plot.logarithmic = { true, true };
  plot.title = fmt::format("Error of {} % of the pixels against time", Short(100.0 * facts.share));
  plot.up = "error over the range";
  plot.across = facts.ofNext ? "seconds of a later cut" : "seconds to the first picture";
  for (const TradeFamily family : kFamilies)
  {
    Plot::Series series{ Name(family), ColorOf(family), {}, family != TradeFamily::Exact, false };
    for (const TradeRow& row : rows)
    {
      if (row.setting.family == family && row.IsThere() && HasOwnValues(row.setting))
      {
        series.points.push_back({ facts.ofNext ? row.next.Median() : row.first.Median(),
          Relative(row.errors.atShare, facts.range), LabelOf(row.setting) });
      }
    }
    if (!series.points.empty())
    {
      plot.series.push_back(std::move(series));
    }
  }
  return plot.Draw(width, height);
}

std::vector<std::uint8_t> DrawConvergence(
  const std::vector<TradeRow>& rows, const TradeFacts& facts, int width, int height)
{
  Plot plot;
  plot.logarithmic = { true, true };
  plot.title = "Mean error of linear pictures against the exact one";
  plot.up = "mean error over the range";
  plot.across = "spacing over the first one's";
  for (const TradeFamily family : kFamilies)
  {
    Plot::Series series{ Name(family), ColorOf(family), {}, true, false };
    for (const TradeRow& row : rows)
    {
      if (row.setting.family == family && row.setting.spacing > 0.0 && row.IsThere() &&
        row.errors.mean > 0.0)
      {
        series.points.push_back(
          { row.setting.spacing, Relative(row.errors.mean, facts.range), LabelOf(row.setting) });
      }
    }
    if (series.points.empty())
    {
      continue;
    }
    double widest = 0.0;
    for (const Plot::Point& point : series.points)
    {
      widest = std::max(widest, point.x);
    }
    for (Plot::Point& point : series.points)
    {
      point.x /= widest;
    }
    const bool isFirst = plot.series.empty();
    Plot::Series second{ isFirst ? "2nd order" : "", { 130, 130, 130, 255 }, {}, true, true };
    for (const Plot::Point& point : series.points)
    {
      const Plot::Point& last = series.points.back();
      second.points.push_back({ point.x, last.y * std::pow(point.x / last.x, 2.0), "" });
    }
    plot.series.push_back(std::move(series));
    plot.series.push_back(std::move(second));
  }
  return plot.Draw(width, height);
}
} // namespace pixelexact
