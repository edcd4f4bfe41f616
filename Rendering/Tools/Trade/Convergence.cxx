// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/Convergence.h"

#include "Base/Csv.h"
#include "Base/Report.h"
#include "Drawing/Plot.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
double Slope(const SeriesError& a, const SeriesError& b)
{
  return std::log(b.error / a.error) / std::log(b.step / a.step);
}

struct NamedError
{
  const char* name;
  double DifferenceNumbers::*error;
  Rgba color;
};
constexpr std::array kErrors{
  NamedError{ "largest", &DifferenceNumbers::largest, { 200, 30, 30, 255 } },
  NamedError{ "L2", &DifferenceNumbers::rootMeanSquare, { 20, 90, 180, 255 } },
  NamedError{ "mean", &DifferenceNumbers::mean, { 20, 140, 70, 255 } },
};

/// A bound above this share of an error is drawn.
constexpr double kNearBound = 1e-3;

std::string Number(double value)
{
  return fmt::format("{}", value);
}
} // namespace

SeriesAxis AxisOf(std::span<const SolutionSize> sizes)
{
  const auto& orders = sizes.front().orders;
  const bool sameOrder = orders[0] == orders[1] &&
    std::ranges::all_of(
      sizes, [&orders](const SolutionSize& size) { return size.orders == orders; });
  return sameOrder ? SeriesAxis::Length : SeriesAxis::Modes;
}

double StepOf(const SolutionSize& size, SeriesAxis axis)
{
  return axis == SeriesAxis::Length
    ? size.length
    : std::pow(static_cast<double>(size.modes), -1.0 / size.dimensions);
}

double PlaceOf(const SolutionSize& size, SeriesAxis axis)
{
  return axis == SeriesAxis::Length ? size.length : static_cast<double>(size.modes);
}

const char* NameOf(SeriesAxis axis)
{
  return axis == SeriesAxis::Length ? "edge of an element over that of the mesh"
                                    : "modes of a component, summed over the elements";
}

std::optional<SeriesOrder> OrderOfErrors(std::span<const SeriesError> errors)
{
  std::vector<SeriesError> places;
  for (const SeriesError& one : errors)
  {
    // Errors below the bound mean nothing, and equal steps give no slope.
    if (one.error > one.bound && (places.empty() || one.step < places.back().step))
    {
      places.push_back(one);
    }
  }
  if (places.size() < 2)
  {
    return std::nullopt;
  }
  double x = 0.0;
  double y = 0.0;
  for (const SeriesError& place : places)
  {
    x += std::log(place.step) / static_cast<double>(places.size());
    y += std::log(place.error) / static_cast<double>(places.size());
  }
  double above = 0.0;
  double below = 0.0;
  for (const SeriesError& place : places)
  {
    const double off = std::log(place.step) - x;
    above += off * (std::log(place.error) - y);
    below += off * off;
  }
  return SeriesOrder{ above / below, Slope(places[places.size() - 2], places.back()),
    static_cast<int>(places.size()) };
}

Convergence::Convergence(std::vector<SeriesRow> rows)
  : rows_(std::move(rows))
{
  std::vector<SolutionSize> sizes(rows_.size());
  std::ranges::transform(rows_, sizes.begin(), &SeriesRow::size);
  axis_ = AxisOf(sizes);
  std::ranges::stable_sort(
    rows_, std::greater(), [this](const SeriesRow& row) { return StepOf(row.size, axis_); });
}

SeriesError Convergence::ErrorOf(const SeriesRow& row, double DifferenceNumbers::*error) const
{
  return { StepOf(row.size, axis_), row.numbers.*error, row.numbers.largestBound };
}

std::optional<SeriesOrder> Convergence::OrderOf(double DifferenceNumbers::*error) const
{
  std::vector<SeriesError> errors(rows_.size());
  std::ranges::transform(
    rows_, errors.begin(), [&](const SeriesRow& row) { return ErrorOf(row, error); });
  return OrderOfErrors(errors);
}

std::optional<double> Convergence::StepOrder(std::size_t row) const
{
  if (row == 0)
  {
    return std::nullopt;
  }
  const std::array errors{ ErrorOf(rows_[row - 1], &DifferenceNumbers::rootMeanSquare),
    ErrorOf(rows_[row], &DifferenceNumbers::rootMeanSquare) };
  const auto order = OrderOfErrors(errors);
  return order ? std::optional(order->last) : std::nullopt;
}

std::string Convergence::ToCsv() const
{
  std::string text =
    "solution,elements,lowest_order,highest_order,modes,relative_length,largest,l2,"
    "mean,relative_l2,largest_bound,order_of_l2,both,only_reference,only_solution,"
    "unknown,not_finite,unbounded\n";
  for (std::size_t k = 0; k < rows_.size(); ++k)
  {
    const auto& [name, size, numbers] = rows_[k];
    const auto order = StepOrder(k);
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", CsvField(name),
      size.elements, size.orders[0], size.orders[1], size.modes, size.length, numbers.largest,
      numbers.rootMeanSquare, numbers.mean,
      numbers.firstRootMeanSquare > 0.0
        ? Number(numbers.rootMeanSquare / numbers.firstRootMeanSquare)
        : "",
      numbers.largestBound, order ? Number(*order) : "", numbers.both, numbers.onlyFirst,
      numbers.onlySecond, numbers.unknown, numbers.notFinite, numbers.unbounded);
  }
  return text;
}

nlohmann::ordered_json Convergence::ToJson() const
{
  nlohmann::ordered_json json{ { "over",
    axis_ == SeriesAxis::Length ? "relative_length" : "modes" } };
  for (const auto& [name, error, color] : kErrors)
  {
    if (const auto order = OrderOf(error))
    {
      json["orders"][name] = { { "overall", order->overall }, { "last", order->last },
        { "solutions", order->solutions } };
    }
  }
  return json;
}

std::vector<std::uint8_t> Convergence::Draw(
  const std::string& reference, int width, int height) const
{
  Plot plot;
  plot.logarithmic = { true, true };
  plot.title = "Differences from " + reference + " over the pixels";
  plot.up = "difference; order of convergence in the legend";
  plot.across = NameOf(axis_);
  const auto at = [this](const SeriesRow& row) { return PlaceOf(row.size, axis_); };
  for (const auto& [name, error, color] : kErrors)
  {
    const auto order = OrderOf(error);
    Plot::Series series{ order ? fmt::format("{}: {:.2f}", name, order->overall) : name, color, {},
      true, false };
    for (const SeriesRow& row : rows_)
    {
      const bool labelled = error == &DifferenceNumbers::largest;
      series.points.push_back({ at(row), row.numbers.*error,
        labelled ? fmt::format("p{}, {}", OrderText(row.size.orders), row.size.elements)
                 : std::string() });
    }
    plot.series.push_back(std::move(series));
  }
  // A bound far below all errors would compress their range.
  const bool near = std::ranges::any_of(rows_,
    [](const SeriesRow& row) { return row.numbers.largestBound > kNearBound * row.numbers.mean; });
  if (near)
  {
    Plot::Series bound{ "proven bound", { 120, 120, 120, 255 }, {}, true, true };
    for (const SeriesRow& row : rows_)
    {
      bound.points.push_back({ at(row), row.numbers.largestBound, {} });
    }
    plot.series.push_back(std::move(bound));
  }
  return plot.Draw(width, height);
}
} // namespace pixelexact
