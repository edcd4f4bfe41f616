// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FoundRanges.h"

#include "Base/Report.h"

#include "Trace/Scene.h"
#include "Views/FieldRange.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
std::string RangeText(const FoundRange& range)
{
  if (!range)
  {
    return "not finite";
  }
  const auto [lower, upper] = *range;
  // Rounding is no value.
  const double least = 1e-12 * std::max(std::fabs(lower), std::fabs(upper));
  const auto text = [least](double value) { return Short(std::fabs(value) < least ? 0.0 : value); };
  return text(lower) + " to " + text(upper);
}

nlohmann::ordered_json RangeToJson(const FoundRange& range)
{
  return range ? nlohmann::ordered_json(*range) : nlohmann::ordered_json();
}
} // namespace

FoundRanges FindRanges(const Mesh& mesh, const Field& field)
{
  FoundRanges ranges;
  for (int c = 0; c < field.values.components; ++c)
  {
    ranges.components.push_back(AttainedRange(mesh, field, c));
  }
  if (ranges.components.size() > 1)
  {
    ranges.magnitude = AttainedRange(mesh, field, kMagnitude);
  }
  return ranges;
}

void AddTo(Table& table, const FoundRanges& ranges)
{
  if (ranges.components.size() == 1)
  {
    table.Row("", "  values {}", RangeText(ranges.components.front()));
    return;
  }
  std::vector<std::string> texts;
  for (std::size_t c = 0; c < ranges.components.size(); ++c)
  {
    texts.push_back(fmt::format("component {} {}", c, RangeText(ranges.components[c])));
  }
  table.Row("", "  {}; magnitude {}", Listed(texts), RangeText(ranges.magnitude));
}

void AddTo(nlohmann::ordered_json& field, const FoundRanges& ranges)
{
  field["ranges"] = nlohmann::ordered_json::array();
  for (const FoundRange& range : ranges.components)
  {
    field["ranges"].push_back(RangeToJson(range));
  }
  if (ranges.components.size() > 1)
  {
    field["magnitude_range"] = RangeToJson(ranges.magnitude);
  }
}
} // namespace pixelexact
