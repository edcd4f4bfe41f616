// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/ValuePlots.h"

#include "Base/Command.h"
#include "Base/Options.h"
#include "Base/Output.h"
#include "Base/Report.h"

#include "Core/Base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace pixelexact
{
namespace
{
void CheckCount(const Plot& plot, const char* remedy)
{
  if (plot.series.size() > kMaxPlotSeries)
  {
    throw Error(fmt::format("--plot: {} lines cannot be distinguished, at most {} are drawn; {}",
      plot.series.size(), kMaxPlotSeries, remedy));
  }
}

std::string ColumnName(const ProbedField& field, std::size_t component)
{
  return field.samples.components == 1 ? field.name : fmt::format("{}_{}", field.name, component);
}

double ValueOf(const ProbedField& field, std::size_t point, std::size_t component)
{
  return field.samples.value[point * field.samples.components + component];
}

/// The name of a series of a step: the field's, the input's where there are several, and the time
/// where the input has several steps.
std::string NameOfStep(
  const std::string& field, const ProbedStep& step, const std::vector<ProbedStep>& steps)
{
  const auto isOther = [&step](const ProbedStep& other)
  { return other.input == step.input && other.step != step.step; };
  std::string name = field;
  if (!step.input.empty())
  {
    name = step.fields.size() > 1 || step.fields.front().samples.components > 1
      ? name + ", " + step.input
      : step.input;
  }
  return std::ranges::any_of(steps, isOther) ? fmt::format("{}, t={}", name, Short(step.time, 4))
                                             : name;
}

Plot AlongLine(const ProbePoints& points, const std::vector<ProbedStep>& steps)
{
  Plot plot;
  plot.across = "distance from the line's first point";
  for (const ProbedStep& step : steps)
  {
    for (const ProbedField& field : step.fields)
    {
      for (std::size_t c = 0; c < field.samples.components; ++c)
      {
        Plot::Series series{ ColumnName(field, c), SeriesColor(plot.series.size()), {}, true, false,
          false };
        series.name = NameOfStep(series.name, step, steps);
        for (std::size_t k = 0; k < points.x.size(); ++k)
        {
          series.points.push_back({ points.distance[k], ValueOf(field, k, c), {} });
        }
        plot.series.push_back(std::move(series));
      }
    }
  }
  CheckCount(plot, "name fewer fields or inputs, or one --time-step");
  return plot;
}

/// Adds the series of one input's steps.
void AddOverTime(const ProbePoints& points, std::span<const ProbedStep> steps, Plot& plot)
{
  const std::vector<ProbedField>& fields = steps.front().fields;
  const std::string input = steps.front().input.empty() ? "" : ", " + steps.front().input;
  const bool isAlone = fields.size() == 1 && fields.front().samples.components == 1;
  for (std::size_t k = 0; k < points.x.size(); ++k)
  {
    for (std::size_t f = 0; f < fields.size(); ++f)
    {
      for (std::size_t c = 0; c < fields[f].samples.components; ++c)
      {
        Plot::Series series{ fmt::format("{}point {}{}",
                               isAlone ? "" : ColumnName(fields[f], c) + ", ", k, input),
          SeriesColor(plot.series.size()), {}, true, false, true };
        series.points.reserve(steps.size());
        for (const ProbedStep& step : steps)
        {
          series.points.push_back({ step.time, ValueOf(step.fields[f], k, c), {} });
        }
        plot.series.push_back(std::move(series));
        CheckCount(plot, "give fewer points");
      }
    }
  }
}

Plot OverTime(const ProbePoints& points, const std::vector<ProbedStep>& steps)
{
  Plot plot;
  plot.across = "time";
  for (auto from = steps.begin(); from != steps.end();)
  {
    const auto to = std::find_if(
      from, steps.end(), [&](const ProbedStep& step) { return step.input != from->input; });
    AddOverTime(points, { from, to }, plot);
    from = to;
  }
  return plot;
}
} // namespace

void PlotOptions::AddTo(CLI::App& command)
{
  Bind(command, "--plot", File);
  Bind(command, "--plot-size", Size);
  Bind(command, "--plot-title", Title);
}

void PlotOptions::Check(const std::vector<std::string>& read) const
{
  if (IsAsked())
  {
    (void)FormatOf("--plot", File);
    CheckOutput("--plot", File, read);
  }
}

void PlotOptions::Write(Plot plot) const
{
  plot.title = Title.empty() ? plot.title : Title;
  const ImageSize size = AtDpi(Size, kDefaultDpi);
  WriteBytes(File, plot.Encode(FormatOf("--plot", File), size.width, size.height, {}, {}, File));
}

Plot PlotOfProbe(const ProbePoints& points, const std::vector<ProbedStep>& steps)
{
  const bool isLine = !points.distance.empty();
  if (!isLine && steps.front().step == steps.back().step)
  {
    throw Error(
      "--plot: the points are on no line and at one time; give --line, or --time-step all");
  }
  Plot plot = isLine ? AlongLine(points, steps) : OverTime(points, steps);
  if (plot.series.empty())
  {
    throw Error("--plot: the input has no field; name the file of a field");
  }
  plot.up = plot.series.size() == 1 ? plot.series.front().name : "value";
  if (plot.series.size() == 1)
  {
    plot.series.front().name.clear();
  }
  return plot;
}

Plot PlotOfHistogram(const std::string& field, const std::vector<HistogramClass>& histogram)
{
  constexpr double kPercent = 100.0;
  Plot plot;
  plot.across = field;
  plot.up = "per cent of the area";
  for (const HistogramClass& one : histogram)
  {
    plot.bars.push_back({ one.from, one.to, kPercent * one.part.Middle(),
      { kPercent * one.part.lower, kPercent * one.part.upper } });
  }
  return plot;
}

Plot PlotOfRows(
  const std::string& field, const std::string& quantity, std::span<const TimedRows> all)
{
  std::map<std::pair<std::string, std::string>, std::size_t> numbers;
  Plot plot;
  plot.across = "time";
  plot.up = quantity + (field.empty() ? "" : " of " + field);
  std::vector<std::string> known;
  for (const TimedRows& timed : all)
  {
    for (const IntegralRow& row : timed.rows)
    {
      if (std::ranges::find(known, row.quantity) == known.end())
      {
        known.push_back(row.quantity);
      }
      if (row.quantity != quantity && !row.quantity.starts_with(quantity + " "))
      {
        continue;
      }
      const auto [at, isNew] = numbers.try_emplace({ timed.surface, row.quantity }, numbers.size());
      if (isNew)
      {
        plot.series.push_back({ row.quantity, SeriesColor(at->second), {}, true, false });
      }
      plot.series[at->second].points.push_back({ timed.time, row.Middle(), {} });
    }
  }
  if (plot.series.empty())
  {
    throw Error("--plot-quantity: there is no '" + quantity + "'; there are " + Listed(known));
  }
  CheckCount(plot, "give fewer surfaces");
  const bool areSeveral = all.front().surface != all.back().surface;
  for (const auto& [key, number] : numbers)
  {
    plot.series[number].name = areSeveral ? key.first.substr(2) : plot.series[number].name;
  }
  if (plot.series.size() == 1)
  {
    plot.series.front().name.clear();
  }
  return plot;
}
} // namespace pixelexact
