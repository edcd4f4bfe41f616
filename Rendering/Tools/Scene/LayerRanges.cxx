// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/LayerRanges.h"

#include "Base/Command.h"
#include "Base/Numbers.h"
#include "Base/Options.h"
#include "Base/Report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pixelexact
{
namespace
{
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

RangeRule ReadRange(const std::string& option, const std::string& text, char separator)
{
  using Of = RangeRule::Of;
  static const std::map<std::string_view, RangeRule> kNamed{ { "cut", { Of::Cut } },
    { "field", { Of::Field } }, { "all", { Of::All } }, { "symmetric", { Of::Cut, {}, true } },
    { "symmetric-cut", { Of::Cut, {}, true } }, { "symmetric-field", { Of::Field, {}, true } },
    { "symmetric-all", { Of::All, {}, true } } };
  if (const auto named = kNamed.find(text); named != kNamed.end())
  {
    return named->second;
  }
  RangeRule choice;
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

PixelsBeyond CountBeyond(const Frame& frame, const std::vector<ValueRange>& ranges, bool logarithm)
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
