// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/Csv.h"
#include "Base/Output.h"
#include "Base/Report.h"
#include "Commands/ProbeReport.h"
#include "Commands/ProbeTable.h"
#include "Commands/ValuePlots.h"
#include "Input/OtherInputs.h"
#include "Scene/Model.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Error.h"
#include "Files/TimeSeries.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace pixelexact
{
namespace
{
struct ProbeOptions
{
  InputRequest input;
  std::vector<std::string> fields; ///< none: the first one, where there is one
  std::string points;
  std::vector<double> line; ///< from, to, and number of points; empty: points of a file
  bool lineHasZ = true;     ///< false: z are set later, 0 until then
  std::string output = "-";
  ProbeColumns columns;
  PlotOptions plot;
  OtherInputs with;
};

/// The fields to evaluate; none where the input has none. Points are then only located and their
/// coverage counted. `input`: the name of one of several inputs, whose field may have another name;
/// empty: there is one input.
std::vector<const Field*> FieldsToProbe(const HighOrderModel& model, const ProbeOptions& options,
  const std::vector<std::string>& names, const std::string& input)
{
  if (!names.empty())
  {
    std::vector<const Field*> fields;
    fields.reserve(names.size());
    for (const std::string& name : names)
    {
      fields.push_back(
        input.empty() ? &model.GetField(name) : &FieldNamedOrOnly(model, name, input));
    }
    return fields;
  }
  if (!model.Fields().empty())
  {
    return { &FieldOrFirst(model, {}) };
  }
  if (options.columns.gradient || options.columns.enclosures)
  {
    throw Error(std::string(options.columns.gradient ? "--gradient" : "--enclosures") +
      ": the input has no field; leave it out, or name the file of a field");
  }
  return {};
}

/// Refuses names of other formats. Programs would open the table by its suffix.
void CheckTableName(const std::string& file)
{
  constexpr std::array kOtherFormats{ ".npy", ".npz", ".vtk", ".vtp", ".vtu", ".vti", ".json",
    ".h5", ".hdf5", ".parquet", ".xls", ".xlsx", ".ods", ".tsv", ".gz" };
  if (std::ranges::find(kOtherFormats, LowerSuffix(file)) != kOtherFormats.end())
  {
    throw UsageError("--output: '" + file + "' is written as .csv; name it so");
  }
}

/// Number of commas in x0,y0,x1,y1,n.
constexpr std::ptrdiff_t kPlaneCommas = 4;
constexpr const char* kLineForm = "x0,y0,z0,x1,y1,z1,n";

/// Points, and whether the user gave their z.
struct GivenPoints
{
  ProbePoints points;
  PointTable table; ///< without the points; for a line only `hasZ` is set
};

GivenPoints PointsOf(const ProbeOptions& options)
{
  GivenPoints given;
  if (options.line.empty())
  {
    given.table = ReadPoints(options.points);
    given.points.x = std::move(given.table.points);
    return given;
  }
  const std::vector<double>& l = options.line;
  given.points = PointsOnLine({ l[0], l[1], l[2] }, { l[3], l[4], l[5] }, static_cast<int>(l[6]));
  given.table.hasZ = options.lineHasZ;
  return given;
}

/// Moves points with x and y only to the plane of a 2-D mesh.
void AddZ(const ProbeOptions& options, const LoadedModel& input, GivenPoints& given)
{
  if (given.table.hasZ)
  {
    return;
  }
  const std::optional<Slab> slab = SlabOf(input.grid);
  if (!slab || slab->inSpace)
  {
    if (!options.line.empty())
    {
      throw UsageError(std::string("--line: the mesh is 3-D; give ") + kLineForm);
    }
    RequireZ(options.points, given.table);
    return;
  }
  for (Vec3& point : given.points.x)
  {
    point.z = slab->middle;
  }
}

/// Locates the points and evaluates each field. Without fields, one entry with locations only.
std::vector<ProbedField> ProbeFields(const LoadedModel& input,
  const std::vector<const Field*>& fields, const std::vector<std::string>& names,
  const ProbePoints& points, const ProbeColumns& columns)
{
  const Locator& locator = input.model->GetLocator();
  std::vector<ProbedField> probed;
  for (std::size_t k = 0; k < std::max<std::size_t>(1, fields.size()); ++k)
  {
    const Field* field = fields.empty() ? nullptr : fields[k];
    ProbeColumns own = columns;
    own.owners = own.owners && k == 0;
    const int components = field != nullptr ? field->values.components : 0;
    probed.push_back(
      { fields.size() > 1 ? names[k] : "value", ProbeSamples(points.x.size(), components, own) });
    Sample(locator, field, points.x, probed.back().samples.Target());
  }
  return probed;
}

/// Evaluates the fields of one time step.
ProbedStep ProbeStep(const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<std::string>& names, const ProbePoints& points, const ProbeOptions& options,
  Stopwatch& stopwatch)
{
  const Locator& locator = input.model->GetLocator();
  stopwatch.Stage("bounds+bvh");
  ProbedStep step;
  step.step = input.step;
  step.time = TimeOf(input);
  step.fields = ProbeFields(input, fields, names, points, options.columns);
  stopwatch.Stage("probe");
  if (options.columns.owners)
  {
    FindOwners(locator, points.x, step.fields.front().samples.owners);
    stopwatch.Stage("owners");
  }
  const auto cells = input.model->SourceCells();
  step.sourceCells.assign(cells.begin(), cells.end());
  return step;
}

bool HaveSameColumns(const ProbedStep& a, const ProbedStep& b)
{
  return std::ranges::equal(a.fields, b.fields,
    [](const ProbedField& one, const ProbedField& other)
    { return one.samples.components == other.samples.components; });
}

/// The points and results of a run, which grow input by input and step by step.
struct ProbeRun
{
  GivenPoints given;
  std::vector<std::string> names; ///< of the fields
  std::vector<ProbedStep> steps;
  std::vector<nlohmann::ordered_json> summaries;
  Table table;
};

/// Probes one input at one time step. `name`: as FieldsToProbe.
void ProbeInput(const LoadedModel& input, const std::string& name, const ProbeOptions& options,
  bool json, Stopwatch& stopwatch, ProbeRun& run)
{
  if (options.columns.gradient)
  {
    input.model->RequireSolids("--gradient");
  }
  if (run.steps.empty() || run.steps.back().input != name)
  {
    WarnOfDiagnostics(input);
  }
  if (run.steps.empty())
  {
    AddZ(options, input, run.given);
  }
  const std::vector<const Field*> fields = FieldsToProbe(*input.model, options, run.names, name);
  if (run.names.empty() && !fields.empty())
  {
    run.names.push_back(fields.front()->name);
  }
  run.steps.push_back(ProbeStep(input, fields, run.names, run.given.points, options, stopwatch));
  ProbedStep& step = run.steps.back();
  step.input = name;
  if (!HaveSameColumns(run.steps.front(), step))
  {
    throw Error(name.empty()
        ? fmt::format(
            "--time-step all: the fields of step {} differ from those of step {} in their "
            "components; probe them one by one",
            step.step, run.steps.front().step)
        : fmt::format(
            "--with '{}': the fields differ from those of '{}' in their components; probe "
            "them one by one",
            name, run.steps.front().input));
  }
  if (json)
  {
    run.summaries.push_back(ProbeJson(input, fields, step.fields, options.columns));
    if (!name.empty())
    {
      run.summaries.back()["solution"] = name;
    }
    return;
  }
  if (!name.empty())
  {
    run.table.Row("solution", name);
  }
  AddTo(run.table, input, fields, step.fields, options.columns);
}

void Probe(const ProbeOptions& options, const CommonOptions& common)
{
  if (options.points.empty() && options.line.empty())
  {
    throw UsageError("no points were given; name a table of them, --points, or a line, --line");
  }
  const std::vector<InputRequest> requests = options.with.RequestsAfter(options.input);
  std::vector<std::string> read = options.with.Files();
  read.insert(read.end(), options.input.files.begin(), options.input.files.end());
  read.push_back(options.points);
  CheckOutput("--output", options.output, read);
  CheckTableName(options.output);
  options.plot.Check(read);
  CheckStandardOutput({ options.output, options.plot.Name() }, common.json);
  Stopwatch stopwatch;
  // Reads the points first, because this is fast and often fails.
  ProbeRun run{ PointsOf(options), options.fields, {}, {}, {} };
  stopwatch.Stage("points");
  const std::vector<std::string> inputs =
    requests.size() > 1 ? NamesOfInputs(requests) : std::vector<std::string>{ "" };
  // The other inputs may have their field under another name; then all fields are loaded.
  const bool needsAll = options.fields.size() != 1 || requests.size() > 1;
  for (std::size_t k = 0; k < requests.size(); ++k)
  {
    ForEachStep(requests[k], needsAll ? std::string() : options.fields.front(), stopwatch,
      [&](const LoadedModel& input)
      {
        const std::string name =
          inputs[k].empty() ? inputs[k] : SolutionName(inputs[k], requests[k], input);
        ProbeInput(input, name, options, common.json, stopwatch, run);
      });
  }
  WriteProbeTable(options.output, run.given.points, run.steps, options.input.allSteps);
  if (options.plot.IsAsked())
  {
    Plot plot = PlotOfProbe(run.given.points, run.steps);
    if (run.names.size() == 1 && plot.up.starts_with("value"))
    {
      plot.up = run.names.front();
    }
    options.plot.Write(std::move(plot));
  }
  stopwatch.Stage("write");
  if (!common.json)
  {
    AddStages(run.table, stopwatch);
    run.table.Print(IsStandardStream(options.output));
    return;
  }
  nlohmann::ordered_json summary = run.summaries.front();
  if (options.input.allSteps || requests.size() > 1)
  {
    summary = { { options.input.allSteps ? "steps" : "solutions", run.summaries } };
  }
  summary["seconds"] = ToJson(stopwatch);
  Print(summary);
}

/// Reads six coordinates and a number of points, or four in a plane, whose z become 0.
std::vector<double> ReadLine(const std::string& text)
{
  constexpr double kMax = 1e9;
  const bool isPlane = std::ranges::count(text, ',') == kPlaneCommas;
  std::vector<double> numbers = ReadNumbers("--line", text, isPlane ? 5 : 7, kLineForm);
  if (isPlane)
  {
    numbers.insert(numbers.begin() + 2, 0.0);
    numbers.insert(numbers.begin() + 5, 0.0);
  }
  if (!(numbers[6] >= 2.0 && numbers[6] <= kMax && numbers[6] == std::floor(numbers[6])))
  {
    Refuse("--line", text, std::string(kLineForm) + " with a whole number n from 2 to 1000000000");
  }
  return numbers;
}
} // namespace

void AddProbeCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<ProbeOptions>();
  CLI::App& command = AddCommand(program, "probe",
    "Evaluate a field at the points of a table; without a field, locate them",
    [options, &common, &action] { action = [options, &common] { Probe(*options, common); }; });
  options->input.mayBeAll = true;
  options->input.AddTo(command);
  Bind(command, "--field",
    [options](const std::string& name)
    {
      if (std::ranges::find(options->fields, name) != options->fields.end())
      {
        throw UsageError("--field: '" + name + "' is there twice; give it once");
      }
      options->fields.push_back(name);
    });
  Bind(command, "--points", options->points);
  Bind(command, "--line",
    [options](const std::string& text)
    {
      options->line = ReadLine(text);
      options->lineHasZ = std::ranges::count(text, ',') != kPlaneCommas;
    });
  Bind(command, "--output", options->output);
  Bind(command, "--gradient", options->columns.gradient);
  Bind(command, "--enclosures", options->columns.enclosures);
  Bind(command, "--owners", options->columns.owners);
  options->plot.AddTo(command);
  options->with.AddTo(command);
}
} // namespace pixelexact
