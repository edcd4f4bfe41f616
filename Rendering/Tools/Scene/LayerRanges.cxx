// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/LayerRanges.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Options.h"
#include "Base/Report.h"
#include "Scene/Shot.h"

#include "Core/Base/Error.h"
#include "Views/FieldRange.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pixelexact
{
namespace
{
/// Over the mesh.
std::array<double, 2> RangeOfField(const Shot& shot, const Layer& layer, bool logarithm)
{
  ProgressLine line("bounding");
  const auto range = FieldRange(shot.input.model->GetMesh(), *layer.field, layer.component,
    [&line](double part) { line(part); });
  const std::string name = "--range field: field '" + layer.field->name + "' ";
  if (!range)
  {
    throw Error(name + "has no finite value; choose --range cut or --range a,b");
  }
  if (logarithm && !((*range)[0] > 0.0))
  {
    throw Error(name + "is only proven to be above " + Short((*range)[0]) +
      ", and --log needs values above 0; choose --range cut or --range a,b");
  }
  return *range;
}

bool ShowTheSame(const Layer& a, const Layer& b)
{
  return a.field == b.field && a.component == b.component;
}

/// The sheets that rays go through, the nearest first.
std::vector<const SampleBuffers*> SheetsOf(const Frame& frame)
{
  std::vector<const SampleBuffers*> sheets{ &frame.centres };
  for (const SampleBuffers& sheet : frame.centres.behind)
  {
    sheets.push_back(&sheet);
  }
  return sheets;
}

bool IsExact(const SampleBuffers& samples, std::size_t i)
{
  return samples.verdict[i] == static_cast<std::uint8_t>(PixelVerdict::Exact);
}

std::size_t LayerOf(const SampleBuffers& samples, std::size_t i)
{
  return samples.layer.empty() ? 0 : samples.layer[i];
}

std::array<double, 2> Joined(const std::optional<std::array<double, 2>>& range, double value)
{
  return range ? std::array{ std::min((*range)[0], value), std::max((*range)[1], value) }
               : std::array{ value, value };
}

/// Calls `visit` with the finite values of exact pixels above `lowest` on these layers.
template <class Visit>
void VisitValues(
  const Frame& frame, double lowest, const std::vector<bool>& layers, const Visit& visit)
{
  for (const SampleBuffers* samples : SheetsOf(frame))
  {
    for (std::size_t i = 0; i < samples->value.size(); ++i)
    {
      const double value = samples->value[i];
      if (IsExact(*samples, i) && std::isfinite(value) && value > lowest &&
        (layers.empty() || layers[LayerOf(*samples, i)]))
      {
        visit(value);
      }
    }
  }
}

/// Between the two values whose ranks are nearest, by the part of the way.
double Percentile(std::vector<double>& values, double percent)
{
  const double rank = percent / 100.0 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(std::floor(rank));
  const auto at = values.begin() + below;
  std::nth_element(values.begin(), at, values.end());
  const double part = rank - static_cast<double>(below);
  return part > 0.0 ? std::lerp(*at, *std::min_element(at + 1, values.end()), part) : *at;
}

/// Of the values that the picture shows; none: there are none.
std::optional<std::array<double, 2>> PercentileRange(const Frame& frame, double lowest,
  const std::vector<bool>& layers, const std::array<double, 2>& percents)
{
  std::vector<double> values;
  VisitValues(frame, lowest, layers, [&values](double value) { values.push_back(value); });
  return values.empty()
    ? std::nullopt
    : std::optional(std::array{ Percentile(values, percents[0]), Percentile(values, percents[1]) });
}

std::array<double, 2> Symmetric(const std::array<double, 2>& range)
{
  const double most = std::max(std::fabs(range[0]), std::fabs(range[1]));
  return { -most, most };
}
} // namespace

RangeChoice ReadRange(const std::string& option, const std::string& text, char separator)
{
  using Of = RangeChoice::Of;
  static const std::map<std::string_view, RangeChoice> kNamed{ { "cut", { Of::Cut } },
    { "field", { Of::Field } }, { "all", { Of::All } }, { "symmetric", { Of::Cut, {}, true } },
    { "symmetric-cut", { Of::Cut, {}, true } }, { "symmetric-field", { Of::Field, {}, true } },
    { "symmetric-all", { Of::All, {}, true } } };
  if (const auto named = kNamed.find(text); named != kNamed.end())
  {
    return named->second;
  }
  RangeChoice choice;
  const auto middle = text.find(separator);
  std::string_view first = std::string_view(text).substr(0, middle);
  std::string_view second =
    middle == std::string::npos ? std::string_view() : std::string_view(text).substr(middle + 1);
  const bool parts = first.ends_with('%') && second.ends_with('%');
  choice.of = parts ? Of::Parts : Of::Ends;
  first.remove_suffix(parts ? 1 : 0);
  second.remove_suffix(parts ? 1 : 0);
  auto& [lower, upper] = choice.ends;
  if (!ParseNumber(first, lower) || !ParseNumber(second, upper) || !std::isfinite(lower) ||
    !std::isfinite(upper) || (parts && !(lower >= 0.0 && upper <= 100.0)))
  {
    Refuse(option, text,
      fmt::format("cut, field, symmetric, two numbers a{0}b or two percentages from 0 to 100, "
                  "1%{0}99%",
        separator));
  }
  if (!(lower < upper))
  {
    Refuse(option, text, "the first value below the second");
  }
  return choice;
}

std::optional<std::array<double, 2>> ValueRange(
  const Frame& frame, double lowest, const std::vector<bool>& layers)
{
  std::optional<std::array<double, 2>> range;
  VisitValues(frame, lowest, layers, [&range](double value) { range = Joined(range, value); });
  return range;
}

std::array<double, 2> RangeOfLayer(const RangeChoice& choice, const Shot& shot, std::size_t layer,
  const Frame& frame, bool logarithm)
{
  const std::vector<Layer>& layers = shot.scene.layers;
  const auto sided = [&choice](const std::array<double, 2>& range)
  { return choice.symmetric ? Symmetric(range) : range; };
  switch (choice.of)
  {
    case RangeChoice::Of::Ends:
      return choice.ends;
    case RangeChoice::Of::Field:
      return sided(RangeOfField(shot, layers[layer], logarithm));
    default:
      break;
  }
  std::vector<bool> together;
  together.reserve(layers.size());
  for (std::size_t k = 0; k < layers.size(); ++k)
  {
    // What is painted in one colour shows no values but its own, by contours.
    const bool shows = k == layer || !shot.settings[k].color;
    together.push_back(shows && ShowTheSame(layers[k], layers[layer]));
  }
  const double lowest = logarithm ? 0.0 : -std::numeric_limits<double>::infinity();
  const auto seen = choice.of == RangeChoice::Of::Parts
    ? PercentileRange(frame, lowest, together, choice.ends)
    : ValueRange(frame, lowest, together);
  const auto range =
    choice.of == RangeChoice::Of::All && !shot.valuesOfAll.empty() ? shot.valuesOfAll[layer] : seen;
  if (!range)
  {
    return logarithm ? std::array{ 1.0, 10.0 } : std::array{ 0.0, 1.0 };
  }
  const auto shown = BeyondRounding(*layers[layer].field, *range);
  return logarithm && !(shown[0] > 0.0) ? *range : sided(shown);
}

PixelsBeyond CountBeyond(const Frame& frame,
  const std::vector<std::optional<std::array<double, 2>>>& ranges, bool logarithm)
{
  PixelsBeyond count;
  std::optional<std::array<double, 2>> without;
  const std::vector<const SampleBuffers*> sheets = SheetsOf(frame);
  for (std::size_t i = 0; i < frame.centres.value.size(); ++i)
  {
    bool below = false;
    bool above = false;
    bool noLogarithm = false;
    for (const SampleBuffers* samples : sheets)
    {
      const double value = samples->value[i];
      const auto range = IsExact(*samples, i) ? ranges[LayerOf(*samples, i)] : std::nullopt;
      if (!range || std::isnan(value))
      {
        continue;
      }
      if (logarithm && !(value > 0.0))
      {
        noLogarithm = true;
        without = Joined(without, value);
        continue;
      }
      below = below || value < (*range)[0];
      above = above || value > (*range)[1];
    }
    count.below += below ? 1 : 0;
    count.above += above ? 1 : 0;
    count.noLogarithm += noLogarithm ? 1 : 0;
  }
  count.noLogarithmRange = without.value_or(count.noLogarithmRange);
  return count;
}
} // namespace pixelexact
