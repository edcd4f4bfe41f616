// SPDX-License-Identifier: BSD-3-Clause
#include "ProbeTable.h"

#include "Csv.h"
#include "Output.h"

#include "Core/Math/Interval.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
std::string Header(const ProbeSamples& samples)
{
  std::string header = "x,y,z";
  const auto name = [&samples](std::size_t c)
  { return samples.components == 1 ? std::string("value") : "value_" + std::to_string(c); };
  for (std::size_t c = 0; c < samples.components; ++c)
  {
    header += "," + name(c);
  }
  for (std::size_t c = 0; !samples.gradient.empty() && c < samples.components; ++c)
  {
    header += "," + name(c) + "_x," + name(c) + "_y," + name(c) + "_z";
  }
  for (std::size_t c = 0; !samples.lower.empty() && c < samples.components; ++c)
  {
    header += "," + name(c) + "_lower," + name(c) + "_upper";
  }
  header += ",element,xi_0,xi_1,xi_2,verdict";
  return header + (samples.owners.empty() ? "\n" : ",owners,coverage\n");
}

void AppendNumbers(std::string& line, std::span<const double> numbers)
{
  for (const double number : numbers)
  {
    AppendNumber(line, number);
    line += ',';
  }
}

/// The part of an array that holds `width` entries per point.
std::span<const double> Entries(
  const std::vector<double>& array, std::size_t point, std::size_t width)
{
  return array.empty() ? std::span<const double>() : std::span(array).subspan(point * width, width);
}

/// Calls visit(interval, component) for every enclosure of a point inside.
template <class Visit>
void ForEachEnclosure(const ProbeSamples& samples, Visit&& visit)
{
  for (std::size_t i = 0; i < samples.lower.size(); ++i)
  {
    if (samples.verdict[i / samples.components] == Verdict::Inside)
    {
      visit(Interval(samples.lower[i], samples.upper[i]), i % samples.components);
    }
  }
}

/// The least and the largest finite value of each component.
std::vector<Interval> RangesOf(const ProbeSamples& samples)
{
  std::vector<Interval> ranges(samples.components, Interval(INFINITY, -INFINITY));
  for (std::size_t i = 0; i < samples.value.size(); ++i)
  {
    if (std::isfinite(samples.value[i]))
    {
      Interval& range = ranges[i % samples.components];
      range = Join(range, samples.value[i]);
    }
  }
  return ranges;
}
} // namespace

void WriteProbeTable(const std::string& file, std::span<const Vec3> points,
  const ProbeSamples& samples, std::span<const std::int64_t> sourceCells)
{
  OutputFile output(file);
  std::ostream& stream = output.Stream();
  stream << Header(samples);
  const std::size_t width = samples.components;
  std::string line;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    line.clear();
    AppendNumbers(line, std::array{ points[i].x, points[i].y, points[i].z });
    AppendNumbers(line, Entries(samples.value, i, width));
    AppendNumbers(line, Entries(samples.gradient, i, 3 * width));
    for (std::size_t c = 0; !samples.lower.empty() && c < width; ++c)
    {
      AppendNumbers(line, std::array{ samples.lower[i * width + c], samples.upper[i * width + c] });
    }
    const std::int32_t element = samples.element[i];
    line += std::to_string(element < 0 ? -1 : sourceCells[static_cast<std::size_t>(element)]) + ',';
    AppendNumbers(line, std::array{ samples.xi[i].x, samples.xi[i].y, samples.xi[i].z });
    line += Name(samples.verdict[i]);
    if (!samples.owners.empty())
    {
      line += ',' + std::to_string(samples.owners[i].preimages) + ',';
      line += Name(samples.owners[i].coverage);
    }
    line += '\n';
    stream << line;
  }
  output.Close();
}

ProbeCounts CountProbes(const ProbeSamples& samples)
{
  ProbeCounts counts;
  for (std::size_t i = 0; i < samples.verdict.size(); ++i)
  {
    const Verdict verdict = samples.verdict[i];
    counts.outside += verdict == Verdict::Outside ? 1 : 0;
    counts.unknown += verdict == Verdict::Unknown ? 1 : 0;
    if (verdict == Verdict::Inside)
    {
      ++counts.inside;
      const auto value = Entries(samples.value, i, samples.components);
      const bool finite =
        std::all_of(value.begin(), value.end(), [](double v) { return std::isfinite(v); });
      counts.nonFinite += finite ? 0 : 1;
    }
  }
  return counts;
}

EnclosureWidths MeasureEnclosures(const ProbeSamples& samples)
{
  const std::vector<Interval> ranges = RangesOf(samples);
  EnclosureWidths widths;
  std::vector<double> relative;
  ForEachEnclosure(samples,
    [&](const Interval& interval, std::size_t component)
    {
      const Interval& range = ranges[component];
      if (!interval.IsFinite())
      {
        ++widths.unbounded;
      }
      else if (range.lower < range.upper)
      {
        relative.push_back(interval.Width() / (range.upper - range.lower));
      }
    });
  if (!relative.empty())
  {
    const auto middle = relative.begin() + static_cast<std::ptrdiff_t>(relative.size() / 2);
    std::ranges::nth_element(relative, middle);
    widths.median = *middle;
    widths.largest = std::ranges::max(relative);
  }
  return widths;
}

CoverageCounts CountCoverage(const ProbeSamples& samples)
{
  CoverageCounts counts{};
  for (const Owners& owners : samples.owners)
  {
    ++counts[static_cast<std::size_t>(owners.coverage)];
  }
  return counts;
}
} // namespace pixelexact
