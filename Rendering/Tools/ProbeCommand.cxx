// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Csv.h"
#include "Input.h"
#include "Model.h"
#include "Output.h"
#include "ProbeTable.h"
#include "Report.h"

#include "Core/Base/Error.h"

#include <nlohmann/json.hpp>

#include <array>
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
  ProbeColumns columns;
};

void AddEnclosures(nlohmann::ordered_json& summary, const ProbeSamples& samples)
{
  const EnclosureWidths widths = MeasureEnclosures(samples);
  summary["enclosures"] = { { "median_width", widths.median }, { "largest_width", widths.largest },
    { "unbounded", widths.unbounded } };
}

void AddEnclosures(Table& table, const ProbeSamples& samples)
{
  const EnclosureWidths widths = MeasureEnclosures(samples);
  // Two digits say all that there is to say of a width.
  table.Row("enclosures", "median width {}, largest {} of the range of values",
    Short(widths.median, 2), Short(widths.largest, 2));
  if (widths.unbounded > 0)
  {
    table.Row("", "{} unbounded", widths.unbounded);
  }
}

constexpr std::array kCoverages{ Coverage::None, Coverage::Once, Coverage::Several,
  Coverage::Undecided };

void AddCoverage(nlohmann::ordered_json& summary, const ProbeSamples& samples)
{
  const CoverageCounts counts = CountCoverage(samples);
  for (const Coverage kind : kCoverages)
  {
    summary["coverage"][Name(kind)] = counts[static_cast<std::size_t>(kind)];
  }
}

void AddCoverage(Table& table, const ProbeSamples& samples)
{
  const CoverageCounts counts = CountCoverage(samples);
  std::vector<std::string> entries;
  entries.reserve(kCoverages.size());
  for (const Coverage kind : kCoverages)
  {
    entries.push_back(fmt::format("{} {}", counts[static_cast<std::size_t>(kind)], Name(kind)));
  }
  table.Row("covered", Listed(entries));
}

/// Null where the input has none: points are located, too, and counted how often they are covered.
const Field* FieldToProbe(const HighOrderModel& model, const ProbeOptions& options)
{
  if (!model.Fields().empty() || !options.field.empty())
  {
    return &FieldOrFirst(model, options.field);
  }
  if (options.columns.gradient || options.columns.enclosures)
  {
    throw Error(std::string(options.columns.gradient ? "--gradient" : "--enclosures") +
      ": the input has no field; leave it out, or name the file of a field");
  }
  return nullptr;
}

void Probe(const ProbeOptions& options, const CommonOptions& common)
{
  CheckStandardOutput({ options.output }, common.json);
  std::vector<std::string> read = options.input.files;
  read.push_back(options.points);
  CheckOutput("--output", options.output, read);
  Stopwatch stopwatch;
  // First what is quick and goes wrong often.
  const std::vector<Vec3> points = ReadPoints(options.points);
  stopwatch.Stage("points");
  const LoadedModel input = LoadModel(options.input, options.field, stopwatch);
  WarnOfDiagnostics(input);
  const Field* field = FieldToProbe(*input.model, options);
  const Locator& locator = input.model->GetLocator();
  stopwatch.Stage("bounds+bvh");

  const int components = field != nullptr ? field->values.components : 0;
  ProbeSamples samples(points.size(), components, options.columns);
  Sample(locator, field, points, samples.Target());
  stopwatch.Stage("probe");
  if (options.columns.owners)
  {
    FindOwners(locator, points, samples.owners);
    stopwatch.Stage("owners");
  }
  WriteProbeTable(options.output, points, samples, input.model->SourceCells());
  stopwatch.Stage("write");

  const ProbeCounts counts = CountProbes(samples);
  if (common.json)
  {
    nlohmann::ordered_json summary{ { "field",
                                      field != nullptr ? nlohmann::ordered_json(field->name)
                                                       : nlohmann::ordered_json() },
      { "components", components } };
    AddTime(summary, input);
    summary.update(
      { { "points", points.size() }, { "inside", counts.inside }, { "outside", counts.outside },
        { "unknown", counts.unknown }, { "non_finite", counts.nonFinite } });
    if (options.columns.enclosures)
    {
      AddEnclosures(summary, samples);
    }
    if (options.columns.owners)
    {
      AddCoverage(summary, samples);
    }
    summary["seconds"] = ToJson(stopwatch);
    Print(summary);
    return;
  }
  Table table;
  table.Row("field", field != nullptr ? field->name + FieldKind(*field) : "none");
  AddTime(table, input);
  table.Row("points", "{}: {} inside, {} outside, {} unknown", points.size(), counts.inside,
    counts.outside, counts.unknown);
  if (counts.nonFinite > 0)
  {
    table.Row("non-finite", "{} of the values inside", counts.nonFinite);
  }
  if (options.columns.enclosures)
  {
    AddEnclosures(table, samples);
  }
  if (options.columns.owners)
  {
    AddCoverage(table, samples);
  }
  AddStages(table, stopwatch);
  table.Print(IsStandardStream(options.output));
}
} // namespace

void AddProbeCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<ProbeOptions>();
  CLI::App& command = AddCommand(program, "probe",
    "Evaluate a field at the points of a table; without a field, locate them",
    [options, &common, &action] { action = [options, &common] { Probe(*options, common); }; });
  options->input.AddTo(command);
  AddField(command, options->field);
  AddText(command, "--points", options->points, "FILE",
    "CSV file with a header line and the columns x, y and z; others are ignored; - for standard "
    "input")
    .Required();
  AddText(command, "-o,--output", options->output, "FILE",
    "CSV file to write: the points in their order, the field's values (nan outside), the element's "
    "number "
    "in the input (-1 outside), its reference coordinates and the verdict inside, outside or "
    "unknown; - for standard output")
    .Required();
  AddFlag(command, "--gradient", options->columns.gradient,
    "Also write the gradient in world coordinates");
  AddFlag(command, "--enclosures", options->columns.enclosures,
    "Also write value_lower and value_upper: an interval that is proven to hold the field's value "
    "at the point, the error of the inverse map included (-inf to inf where nothing is proven)");
  AddFlag(command, "--owners", options->columns.owners,
    "Also write how often the mesh covers each point: owners, the preimages in all elements, and "
    "coverage: none (outside, or a gap), once, several (an overlap, or a fold), undecided");
}
} // namespace pixelexact
