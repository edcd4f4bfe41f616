// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Csv.h"
#include "Input.h"
#include "Json.h"
#include "Model.h"
#include "Report.h"

#include "Core/Base/Error.h"
#include "Core/Location/Sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>

namespace pixelexact
{
namespace
{
struct ProbeOptions
{
  InputRequest input;
  std::string field;
  std::string points;
  std::string output;
  bool gradient = false;
};

/// Where each point lies and what the field is there.
struct Samples
{
  Samples(std::size_t points, int components, bool withGradient)
    : element(points)
    , xi(points)
    , verdict(points)
    , value(points * static_cast<std::size_t>(components))
    , gradient(withGradient ? 3 * value.size() : 0)
  {
  }
  [[nodiscard]] SampleTarget Target() { return { element, xi, verdict, {}, value, gradient }; }

  std::vector<std::int32_t> element;
  std::vector<Vec3> xi;
  std::vector<Verdict> verdict;
  std::vector<double> value;
  std::vector<double> gradient;
};

std::string Header(int components, bool gradient)
{
  std::string header = "x,y,z";
  const auto name = [components](int c)
  { return components == 1 ? std::string("value") : "value_" + std::to_string(c); };
  for (int c = 0; c < components; ++c)
  {
    header += "," + name(c);
  }
  for (int c = 0; gradient && c < components; ++c)
  {
    header += "," + name(c) + "_x," + name(c) + "_y," + name(c) + "_z";
  }
  return header + ",element,xi_0,xi_1,xi_2,verdict\n";
}

void AppendNumbers(std::string& line, std::span<const double> numbers)
{
  for (const double number : numbers)
  {
    AppendNumber(line, number);
    line += ',';
  }
}

void Write(const std::string& file, std::span<const Vec3> points, const Samples& samples,
  int components, bool gradient, std::span<const std::int64_t> sourceCells)
{
  std::ofstream stream(file, std::ios::binary);
  stream << Header(components, gradient);
  const auto width = static_cast<std::size_t>(components);
  std::string line;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    line.clear();
    AppendNumbers(line, std::array{ points[i].x, points[i].y, points[i].z });
    AppendNumbers(line, std::span(samples.value).subspan(i * width, width));
    if (gradient)
    {
      AppendNumbers(line, std::span(samples.gradient).subspan(3 * i * width, 3 * width));
    }
    const std::int32_t element = samples.element[i];
    line += std::to_string(element < 0 ? -1 : sourceCells[static_cast<std::size_t>(element)]) + ',';
    AppendNumbers(line, std::array{ samples.xi[i].x, samples.xi[i].y, samples.xi[i].z });
    line += Name(samples.verdict[i]);
    line += '\n';
    stream << line;
  }
  if (!stream.flush())
  {
    throw Error("cannot write '" + file + "'; does its folder exist and is there room?");
  }
}

struct Counts
{
  std::size_t inside = 0;
  std::size_t outside = 0;
  std::size_t unknown = 0;
  std::size_t nonFinite = 0;
};

Counts Count(const Samples& samples, int components)
{
  Counts counts;
  const auto width = static_cast<std::size_t>(components);
  for (std::size_t i = 0; i < samples.verdict.size(); ++i)
  {
    const Verdict verdict = samples.verdict[i];
    counts.outside += verdict == Verdict::Outside ? 1 : 0;
    counts.unknown += verdict == Verdict::Unknown ? 1 : 0;
    if (verdict == Verdict::Inside)
    {
      ++counts.inside;
      const auto value = std::span(samples.value).subspan(i * width, width);
      const bool finite =
        std::all_of(value.begin(), value.end(), [](double v) { return std::isfinite(v); });
      counts.nonFinite += finite ? 0 : 1;
    }
  }
  return counts;
}

void Probe(const ProbeOptions& options, const CommonOptions& common)
{
  Stopwatch stopwatch;
  // First what is quick and goes wrong often.
  const std::vector<Vec3> points = ReadPoints(options.points);
  stopwatch.Stage("points");
  const LoadedModel input = LoadModel(options.input, options.field, stopwatch);
  WarnOfDiagnostics(input);
  const Field& field = FieldNamed(*input.model, options.field);
  const int components = field.values.components;
  const Locator& locator = input.model->GetLocator();
  stopwatch.Stage("bounds+bvh");

  Samples samples(points.size(), components, options.gradient);
  Sample(locator, &field, points, samples.Target());
  stopwatch.Stage("probe");
  Write(options.output, points, samples, components, options.gradient, input.model->SourceCells());
  stopwatch.Stage("write");

  const Counts counts = Count(samples, components);
  if (common.json)
  {
    json::Object summary;
    summary.Add("field", field.name).Add("components", components);
    AddTime(summary, input);
    summary.Add("points", points.size()).Add("inside", counts.inside);
    summary.Add("outside", counts.outside).Add("unknown", counts.unknown);
    summary.Add("non_finite", counts.nonFinite).Add("seconds", ToJson(stopwatch));
    std::cout << summary.String() << '\n';
    return;
  }
  Table table;
  table.Row("field", field.name + FieldKind(field));
  AddTime(table, input);
  table.Row("points",
    std::to_string(points.size()) + ": " + std::to_string(counts.inside) + " inside, " +
      std::to_string(counts.outside) + " outside, " + std::to_string(counts.unknown) + " unknown");
  if (counts.nonFinite > 0)
  {
    table.Row("non-finite", std::to_string(counts.nonFinite) + " of the values inside");
  }
  AddStages(table, stopwatch);
  table.Print();
}
} // namespace

void AddProbeCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  CLI::App* command = program.add_subcommand("probe", "Evaluate a field at the points of a table");
  const auto options = std::make_shared<ProbeOptions>();
  options->input.AddTo(*command);
  command->add_option("--field", options->field, "Name of the field")
    ->required()
    ->type_name("NAME");
  command
    ->add_option("--points", options->points,
      "CSV file with a header line and the columns x, y and z; others are ignored")
    ->required()
    ->type_name("FILE");
  command
    ->add_option("--output", options->output,
      "CSV file to write: the points in their order, values (nan outside), the element's number "
      "in the input (-1 outside), its reference coordinates and the verdict inside, outside or "
      "unknown")
    ->required()
    ->type_name("FILE");
  command->add_flag(
    "--gradient", options->gradient, "Also write the gradient in world coordinates");
  command->callback(
    [options, &common, &action] { action = [options, &common] { Probe(*options, common); }; });
}
} // namespace pixelexact
