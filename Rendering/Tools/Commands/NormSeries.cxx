// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/NormSeries.h"

#include "Base/Report.h"
#include "Input/OtherInputs.h"
#include "Scene/Model.h"

#include "Core/Base/Counted.h"
#include "Core/Base/Error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <limits>

namespace pixelexact
{
namespace
{
constexpr std::array kNorms{ "L1", "L2", "Linf" };
constexpr std::array kNormKeys{ "l1", "l2", "linf" };

/// A norm, by its place in kNorms, and the estimate of its error; NaN where no value is finite.
SeriesError NormOf(const NormedSolution& solution, std::size_t field, std::size_t norm)
{
  const NormsOfField& of = solution.facts.fields[field];
  if (of.norms.largestElement < 0)
  {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return { 0.0, kNone, kNone };
  }
  if (norm < 2)
  {
    const Estimate& number = norm == 0 ? of.norms.l1 : of.norms.l2;
    return { 0.0, number.value, number.error };
  }
  return { 0.0, of.largest ? of.largest->lower : of.norms.largest, 0.0 };
}

std::optional<SeriesOrder> OrderOf(const NormSeries& series, std::size_t field, std::size_t norm)
{
  std::vector<SeriesError> errors;
  errors.reserve(series.solutions.size());
  for (const NormedSolution& solution : series.solutions)
  {
    if (solution.facts.fields[field].norms.notFinite == 0)
    {
      errors.push_back(NormOf(solution, field, norm));
      errors.back().step = StepOf(solution.size, series.axis);
    }
  }
  return OrderOfErrors(errors);
}

/// The size of the field with the most modes: expressions have none of their own.
SolutionSize LargestSize(const LoadedModel& input, const std::string& name)
{
  std::vector<SolutionSize> sizes;
  for (const Field& field : input.model->Fields())
  {
    sizes.push_back(SizeOf(input, field));
  }
  if (sizes.empty())
  {
    throw Error(
      "--with: '" + name + "' has no field, whose order a series needs; name the file of a field");
  }
  return *std::ranges::max_element(sizes, {}, &SolutionSize::modes);
}
} // namespace

NormSeries FindNormSeries(const LoadedModel& first, const NormFacts& facts,
  const InputRequest& request, const OtherInputs& with, const std::vector<std::string>& names)
{
  const std::vector<InputRequest> requests = with.RequestsAfter(request);
  const std::vector<std::string> inputs = NamesOfInputs(requests);
  NormSeries series;
  series.solutions.push_back(
    { SolutionName(inputs.front(), request, first), LargestSize(first, inputs.front()), facts });
  Stopwatch stopwatch;
  for (std::size_t k = 1; k < requests.size(); ++k)
  {
    const LoadedModel input = LoadModel(requests[k], {}, stopwatch);
    WarnOfDiagnostics(input);
    std::vector<std::string> own;
    own.reserve(names.size());
    for (const std::string& name : names)
    {
      own.push_back(FieldNamedOrOnly(*input.model, name, inputs[k]).name);
    }
    series.solutions.push_back({ SolutionName(inputs[k], requests[k], input),
      LargestSize(input, inputs[k]), FindNormFacts(input, own) });
  }
  std::vector<SolutionSize> sizes(series.solutions.size());
  std::ranges::transform(series.solutions, sizes.begin(), &NormedSolution::size);
  series.axis = AxisOf(sizes);
  std::ranges::stable_sort(series.solutions, std::greater(),
    [&series](const NormedSolution& one) { return StepOf(one.size, series.axis); });
  for (std::size_t f = 0; f < names.size(); ++f)
  {
    NormOrders& orders = series.orders.emplace_back();
    for (std::size_t norm = 0; norm < orders.size(); ++norm)
    {
      orders[norm] = OrderOf(series, f, norm);
    }
  }
  return series;
}

void AddTo(Table& table, const NormSeries& series)
{
  const std::vector<NormsOfField>& fields = series.solutions.front().facts.fields;
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    table.Row("series", fields[f].name);
    table.Row("", "{:>9} {:>7} {:>9} {:>9} {:>10} {:>10} {:>10}  solution", "elements", "order",
      "modes", "length", kNorms[0], kNorms[1], kNorms[2]);
    for (const NormedSolution& one : series.solutions)
    {
      const auto text = [&](std::size_t norm) { return Short(NormOf(one, f, norm).error, 4); };
      table.Row("", "{:>9} {:>7} {:>9} {:>9} {:>10} {:>10} {:>10}  {}", one.size.elements,
        OrderText(one.size.orders), one.size.modes, Short(one.size.length, 3), text(0), text(1),
        text(2), one.name);
      if (const int notFinite = one.facts.fields[f].norms.notFinite; notFinite > 0)
      {
        table.Row("", "          not finite in {}, left out of the norms; no part of the slopes",
          Counted(notFinite, "element"));
      }
    }
    for (std::size_t norm = 0; norm < kNorms.size(); ++norm)
    {
      if (const auto& order = series.orders[f][norm])
      {
        table.Row("", "slope of {}: {:.2f}, at the end {:.2f}, {}", kNorms[norm], order->overall,
          order->last,
          series.axis == SeriesAxis::Length ? "over the elements' length"
                                            : "over modes to the power of -1 by the dimension");
      }
    }
  }
}

void AddTo(nlohmann::ordered_json& summary, const NormSeries& series)
{
  auto solutions = nlohmann::ordered_json::array();
  for (const NormedSolution& one : series.solutions)
  {
    nlohmann::ordered_json entry{ { "solution", one.name }, { "elements", one.size.elements },
      { "orders", one.size.orders }, { "modes", one.size.modes },
      { "relative_length", one.size.length } };
    for (std::size_t f = 0; f < one.facts.fields.size(); ++f)
    {
      nlohmann::ordered_json norms{ { "field", one.facts.fields[f].name } };
      for (std::size_t norm = 0; norm < kNorms.size(); ++norm)
      {
        norms[kNormKeys[norm]] = NormOf(one, f, norm).error;
      }
      norms["not_finite_elements"] = one.facts.fields[f].norms.notFinite;
      entry["norms"].push_back(std::move(norms));
    }
    solutions.push_back(std::move(entry));
  }
  auto orders = nlohmann::ordered_json::array();
  for (const NormOrders& field : series.orders)
  {
    auto entry = nlohmann::ordered_json::object();
    for (std::size_t norm = 0; norm < kNorms.size(); ++norm)
    {
      if (const auto& order = field[norm])
      {
        entry[kNormKeys[norm]] = { { "overall", order->overall }, { "last", order->last },
          { "solutions", order->solutions } };
      }
    }
    orders.push_back(std::move(entry));
  }
  summary["norms"]["series"] = {
    { "over", series.axis == SeriesAxis::Length ? "relative_length" : "modes" },
    { "solutions", std::move(solutions) }, { "orders", std::move(orders) }
  };
}

Plot PlotOfNorms(const NormSeries& series)
{
  const std::vector<NormsOfField>& fields = series.solutions.front().facts.fields;
  Plot plot;
  plot.logarithmic = { true, true };
  plot.up = (fields.size() == 1 ? "norms of " + fields.front().name : std::string("norms")) +
    "; slopes in the legend";
  plot.across = NameOf(series.axis);
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    for (std::size_t norm = 0; norm < kNorms.size(); ++norm)
    {
      const auto& order = series.orders[f][norm];
      Plot::Series line{ fields.size() == 1 ? "" : fields[f].name + ", ",
        SeriesColor(plot.series.size()), {} };
      line.name += kNorms[norm];
      line.name += order ? fmt::format(": {:.2f}", order->overall) : std::string();
      line.points.reserve(series.solutions.size());
      for (const NormedSolution& one : series.solutions)
      {
        const bool isLabelled = f == 0 && norm + 1 == kNorms.size();
        line.points.push_back({ PlaceOf(one.size, series.axis), NormOf(one, f, norm).error,
          isLabelled ? "p" + OrderText(one.size.orders) : std::string() });
      }
      plot.series.push_back(std::move(line));
    }
  }
  return plot;
}
} // namespace pixelexact
