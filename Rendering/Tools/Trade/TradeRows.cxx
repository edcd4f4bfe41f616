// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/TradeRows.h"

#include "Base/Report.h"
#include "Bench/FrameTime.h"

#include "Core/Base/Error.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
/// Errors below this, relative to the range, are not used for the order of convergence.
constexpr double kMinError = 1e-6;

/// The slope of the logarithms, by least squares.
double SlopeOf(const std::vector<std::array<double, 2>>& points)
{
  const auto count = static_cast<double>(points.size());
  double x = 0.0;
  double y = 0.0;
  for (const auto& [spacing, error] : points)
  {
    x += std::log(spacing) / count;
    y += std::log(error) / count;
  }
  double xy = 0.0;
  double xx = 0.0;
  for (const auto& [spacing, error] : points)
  {
    xy += (std::log(spacing) - x) * (std::log(error) - y);
    xx += (std::log(spacing) - x) * (std::log(spacing) - x);
  }
  return xy / xx;
}

/// A field of a CSV file on one line, always in quotes.
std::string QuotedOnOneLine(const std::string& text)
{
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
  }
  return quoted + "\"";
}

std::string ShortNumber(double number)
{
  return std::isinf(number) ? "inf" : Short(number, 9);
}

void Measure(const TradeScene& scene, TradeRow& row, const Picture& truth,
  const ErrorMeasure& measure, int turn, bool last)
{
  // One run at a time, because runs keep models in memory.
  const std::unique_ptr<TradeRun> run = MakeRun(scene, row.setting);
  const TradeTime time = run->Measure();
  if (turn == 0)
  {
    return; // what is made once in a process is there now
  }
  row.first.times.push_back(time.first);
  row.next.times.push_back(time.next);
  row.bytes = std::max(row.bytes, time.bytes);
  if (last)
  {
    row.picture = run->Show();
    row.triangles = run->Triangles();
    row.proven = run->ProvenChange();
    row.errors = Compare(truth, row.picture, measure);
    row.unknown =
      std::ranges::count(row.picture.verdict, static_cast<std::uint8_t>(PixelVerdict::Unknown));
  }
}
} // namespace

double TradeSeconds::Median() const
{
  return pixelexact::Median(times);
}

double TradeSeconds::Ratio() const
{
  return pixelexact::Median(Ratios(times, exact));
}

std::vector<TradeRow> MeasureTrade(const TradeScene& scene,
  const std::vector<TradeSetting>& settings, const Picture& truth, const ErrorMeasure& measure,
  int repeat, const std::function<void(double)>& done)
{
  std::vector<TradeRow> rows(settings.size());
  for (std::size_t k = 0; k < settings.size(); ++k)
  {
    rows[k].setting = settings[k];
  }
  int steps = 0;
  for (int turn = 0; turn <= repeat; ++turn)
  {
    for (TradeRow& row : rows)
    {
      try
      {
        if (row.IsThere())
        {
          Measure(scene, row, truth, measure, turn, turn == repeat);
        }
        if (row.IsThere() && turn > 0)
        {
          row.first.exact.push_back(rows.front().first.times.back());
          row.next.exact.push_back(rows.front().next.times.back());
        }
      }
      catch (const Error& error)
      {
        row.refused = error.what();
      }
      done(++steps / static_cast<double>(static_cast<std::size_t>(repeat + 1) * rows.size()));
    }
    if (!rows.front().IsThere())
    {
      throw Error(rows.front().refused);
    }
  }
  return rows;
}

std::vector<TradeOrder> OrdersOf(
  const std::vector<TradeRow>& rows, const std::array<double, 2>& range)
{
  std::vector<TradeOrder> orders;
  for (const TradeFamily family :
    { TradeFamily::Cut, TradeFamily::Resample, TradeFamily::Subdivide, TradeFamily::Gradient })
  {
    std::vector<std::array<double, 2>> points;
    for (const TradeRow& row : rows)
    {
      if (row.setting.family == family && row.IsThere() &&
        Relative(row.errors.mean, range) > kMinError)
      {
        points.push_back({ row.setting.spacing, row.errors.mean });
      }
    }
    std::ranges::sort(points, std::greater());
    if (points.size() >= 3 && points.front()[0] > points.back()[0])
    {
      orders.push_back({ family, SlopeOf(points), SlopeOf({ points.end() - 2, points.end() }),
        static_cast<int>(points.size()) });
    }
  }
  return orders;
}

double Relative(double error, const std::array<double, 2>& range)
{
  const double length = range[1] - range[0];
  return length > 0.0 ? error / length : error;
}

std::string ToCsv(const std::vector<TradeRow>& rows, const std::array<double, 2>& range)
{
  std::string csv =
    "setting,family,spacing,first_seconds,first_ratio,next_seconds,next_ratio,peak_bytes,"
    "triangles,shown,missing,invented,unknown,largest_error,mean_error,share_error,wrong_colors,"
    "contour_pixels,contour_missed,contour_displaced,contour_invented,contour_farthest,proven_"
    "change,refused\n";
  for (const TradeRow& row : rows)
  {
    const PictureErrors& e = row.errors;
    std::vector<std::string> fields{ row.setting.name, Name(row.setting.family),
      row.setting.spacing > 0.0 ? ShortNumber(row.setting.spacing) : "" };
    if (row.IsThere())
    {
      const auto error = [&range](double value) { return ShortNumber(Relative(value, range)); };
      for (const double number :
        { row.first.Median(), row.first.Ratio(), row.next.Median(), row.next.Ratio() })
      {
        fields.push_back(ShortNumber(number));
      }
      fields.push_back(row.bytes >= 0.0 ? fmt::format("{:.0f}", row.bytes) : "");
      fields.push_back(fmt::to_string(row.triangles));
      for (const std::int64_t count : { e.shown, e.missing, e.invented, row.unknown })
      {
        fields.push_back(fmt::to_string(count));
      }
      fields.insert(fields.end(),
        { error(e.largest), error(e.mean), error(e.atShare), fmt::to_string(e.wrongBin) });
      if (e.hasContours)
      {
        for (const std::int64_t count :
          { e.contourPixels, e.contourMissed, e.contourDisplaced, e.contourInvented })
        {
          fields.push_back(fmt::to_string(count));
        }
        fields.push_back(ShortNumber(e.contourFarthest));
      }
    }
    fields.resize(22);
    fields.push_back(row.proven ? ShortNumber(Relative(*row.proven, range)) : "");
    fields.push_back(row.IsThere() ? "" : QuotedOnOneLine(row.refused));
    csv += fmt::format("{}\n", fmt::join(fields, ","));
  }
  return csv;
}
} // namespace pixelexact
