// SPDX-License-Identifier: BSD-3-Clause
#include "LayerRanges.h"

#include "Command.h"
#include "Numbers.h"
#include "Options.h"
#include "Report.h"
#include "Shot.h"

#include "Core/Base/Error.h"
#include "Core/Element/MeshRanges.h"
#include "FieldRange.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
/// Over the mesh.
std::array<double, 2> FieldRange(const Shot& shot, const Layer& layer, bool logarithm)
{
  ProgressLine line("bounding");
  const MeshRange found = RangeOf(shot.input.model->GetMesh(),
    QuestionOf(*layer.field, layer.component), RangeEffort{}, [&line](double part) { line(part); });
  const Interval& range = found.range.outer;
  const std::string name = "--range field: field '" + layer.field->name + "' ";
  if (range.IsEmpty() || !range.IsFinite())
  {
    throw Error(name + (range.IsEmpty() ? "has no finite value" : "could not be bounded") +
      "; choose --range cut or --range a,b");
  }
  if (logarithm && !(range.lower > 0.0))
  {
    throw Error(name + "is only proven to be above " + Short(range.lower) +
      ", and --log needs values above 0; choose --range cut or --range a,b");
  }
  return { range.lower, range.upper };
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
} // namespace

RangeChoice ReadRange(const std::string& option, const std::string& text, char separator)
{
  RangeChoice choice;
  if (text == "cut" || text == "field")
  {
    choice.of = text == "cut" ? RangeChoice::Of::Cut : RangeChoice::Of::Field;
    return choice;
  }
  choice.of = RangeChoice::Of::Ends;
  const auto middle = text.find(separator);
  auto& [lower, upper] = choice.ends;
  if (middle == std::string::npos || !ParseNumber(text.substr(0, middle), lower) ||
    !ParseNumber(text.substr(middle + 1), upper) || !std::isfinite(lower) || !std::isfinite(upper))
  {
    Refuse(option, text, std::string("cut, field or two numbers a") + separator + "b");
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
  for (const SampleBuffers* samples : SheetsOf(frame))
  {
    for (std::size_t i = 0; i < samples->value.size(); ++i)
    {
      const double value = samples->value[i];
      if (IsExact(*samples, i) && std::isfinite(value) && value > lowest &&
        (layers.empty() || layers[LayerOf(*samples, i)]))
      {
        range = Joined(range, value);
      }
    }
  }
  return range;
}

std::array<double, 2> RangeOfLayer(const RangeChoice& choice, const Shot& shot, std::size_t layer,
  const Frame& frame, bool logarithm)
{
  const std::vector<Layer>& layers = shot.scene.layers;
  switch (choice.of)
  {
    case RangeChoice::Of::Ends:
      return choice.ends;
    case RangeChoice::Of::Field:
      return FieldRange(shot, layers[layer], logarithm);
    default:
      break;
  }
  std::vector<bool> together;
  together.reserve(layers.size());
  for (const Layer& other : layers)
  {
    together.push_back(ShowTheSame(other, layers[layer]));
  }
  const double lowest = logarithm ? 0.0 : -std::numeric_limits<double>::infinity();
  const auto range = ValueRange(frame, lowest, together);
  if (!range)
  {
    return logarithm ? std::array{ 1.0, 10.0 } : std::array{ 0.0, 1.0 };
  }
  const auto shown = BeyondRounding(*layers[layer].field, *range);
  return logarithm && !(shown[0] > 0.0) ? *range : shown;
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
