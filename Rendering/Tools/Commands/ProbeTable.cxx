// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/ProbeTable.h"

#include "Base/Csv.h"
#include "Base/Output.h"

#include "Core/Math/Interval.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelexact
{
namespace
{
/// The columns of a field, each after a comma.
std::string ColumnsOf(const ProbedField& field)
{
  const ProbeSamples& samples = field.samples;
  std::string columns;
  const auto add = [&](std::size_t c, const char* what)
  {
    columns +=
      ',' + CsvField(field.name + (samples.components == 1 ? "" : "_" + std::to_string(c)) + what);
  };
  for (std::size_t c = 0; c < samples.components; ++c)
  {
    add(c, "");
  }
  for (std::size_t c = 0; !samples.gradient.empty() && c < samples.components; ++c)
  {
    add(c, "_x");
    add(c, "_y");
    add(c, "_z");
  }
  for (std::size_t c = 0; !samples.lower.empty() && c < samples.components; ++c)
  {
    add(c, "_lower");
    add(c, "_upper");
  }
  return columns;
}

std::string Header(const ProbePoints& points, std::span<const ProbedField> fields, bool withTime)
{
  std::string header = withTime ? "step,time,x,y,z" : "x,y,z";
  header += points.distance.empty() ? "" : ",distance";
  for (const ProbedField& field : fields)
  {
    header += ColumnsOf(field);
  }
  header += ",element,xi_0,xi_1,xi_2,verdict";
  return header + (fields.front().samples.owners.empty() ? "\n" : ",owners,coverage\n");
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

/// The columns of a field.
void AppendValues(std::string& line, const ProbeSamples& samples, std::size_t point)
{
  const std::size_t width = samples.components;
  AppendNumbers(line, Entries(samples.value, point, width));
  AppendNumbers(line, Entries(samples.gradient, point, 3 * width));
  for (std::size_t c = point * width; !samples.lower.empty() && c < (point + 1) * width; ++c)
  {
    AppendNumbers(line, std::array{ samples.lower[c], samples.upper[c] });
  }
}

/// A row per point; `begin`: its first columns.
void WriteRows(
  std::ostream& stream, const std::string& begin, const ProbePoints& points, const ProbedStep& step)
{
  const ProbeSamples& first = step.fields.front().samples;
  std::string line;
  for (std::size_t i = 0; i < points.x.size(); ++i)
  {
    line = begin;
    AppendNumbers(line, std::array{ points.x[i].x, points.x[i].y, points.x[i].z });
    AppendNumbers(line, Entries(points.distance, i, 1));
    for (const ProbedField& field : step.fields)
    {
      AppendValues(line, field.samples, i);
    }
    const std::int32_t element = first.element[i];
    line +=
      std::to_string(element < 0 ? -1 : step.sourceCells[static_cast<std::size_t>(element)]) + ',';
    AppendNumbers(line, std::array{ first.xi[i].x, first.xi[i].y, first.xi[i].z });
    line += Name(first.verdict[i]);
    if (!first.owners.empty())
    {
      line += ',' + std::to_string(first.owners[i].preimages) + ',';
      line += Name(first.owners[i].coverage);
    }
    line += '\n';
    stream << line;
  }
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

ProbePoints PointsOnLine(const Vec3& from, const Vec3& to, int count)
{
  ProbePoints points;
  for (int i = 0; i < count; ++i)
  {
    const double part = static_cast<double>(i) / (count - 1);
    points.x.emplace_back(
      std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part), std::lerp(from.z, to.z, part));
    points.distance.push_back(glm::distance(from, to) * part);
  }
  return points;
}

void WriteProbeTable(const std::string& file, const ProbePoints& points,
  std::span<const ProbedStep> steps, bool withTime)
{
  OutputFile output(file);
  std::ostream& stream = output.Stream();
  stream << (steps.front().input.empty() ? "" : "solution,")
         << Header(points, steps.front().fields, withTime);
  for (const ProbedStep& step : steps)
  {
    std::string first = step.input.empty() ? "" : CsvField(step.input) + ',';
    if (withTime)
    {
      first += std::to_string(step.step) + ',';
      AppendNumbers(first, std::array{ step.time });
    }
    WriteRows(stream, first, points, step);
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
