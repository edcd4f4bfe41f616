// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/Options.h"
#include "Base/Output.h"
#include "Base/Report.h"
#include "Commands/IntegralSurfaces.h"
#include "Commands/ValuePlots.h"
#include "Cuts/IntegralPieces.h"
#include "Cuts/IntegralRows.h"
#include "Cuts/SurfaceStatistics.h"
#include "Input/Input.h"
#include "Scene/Model.h"
#include "Trade/LinearContours.h"

#include "Core/Base/Error.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkImplicitFunction.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace pixelexact
{
namespace
{
struct IntegrateOptions
{
  InputRequest input;
  std::string field;
  IntegralSurfaces surfaces;
  std::optional<double> tolerance;
  std::optional<double> seconds;
  int linear = -1; ///< level; -1: none
  StatisticsRequest statistics;
  PlotOptions plot;
  std::string plotQuantity = "Integral";

  [[nodiscard]] IntegralEffort Effort() const
  {
    IntegralEffort effort;
    effort.tolerance = tolerance.value_or(effort.tolerance);
    effort.seconds = seconds.value_or(effort.seconds);
    return effort;
  }
  [[nodiscard]] StatisticsRequest Statistics() const
  {
    StatisticsRequest request = statistics;
    request.effort = Effort();
    request.isToleranceGiven = tolerance.has_value();
    return request;
  }
};

/// The results of one surface.
struct Answer
{
  std::string name;
  SurfaceIntegral found;
  std::vector<IntegralRow> rows;
  std::optional<LinearIntegral> linear;
  SurfaceStatistics more;
};

Answer Solve(const IntegralSurface& surface, const LoadedModel& input, const Field* field,
  const IntegrateOptions& options)
{
  const HighOrderModel& model = *input.model;
  Answer answer{ surface.name, {}, {}, std::nullopt, {} };
  const std::vector<ImplicitPolynomial> clips = options.surfaces.Clips();
  std::optional<IsoValueSurface> cut;
  if (surface.iso)
  {
    const IsoChoice iso = Resolve(*surface.iso, model);
    cut.emplace(model.GetField(iso.field), iso.component, iso.value);
  }
  const SurfaceDomain domain = cut ? DomainOfCut(*cut, clips, model)
    : surface.boundary             ? DomainOfBoundary(surface.attributes, clips, model)
                                   : DomainOfPatches(surface.patches, clips, model);
  answer.found = domain.integrate(field, options.Effort(), std::nullopt);
  answer.rows = RowsOf({ model.GetMesh(), field, nullptr }, answer.found);
  if (!options.statistics.IsEmpty())
  {
    if (field == nullptr)
    {
      throw Error(
        "the input has no field; norms, extremes and statistics are those of a field: name "
        "its file, or an expression with --field");
    }
    answer.more = FindStatistics(model, field->name, domain, answer.found, options.Statistics());
    answer.rows.insert(answer.rows.end(), answer.more.rows.begin(), answer.more.rows.end());
  }
  if (options.linear >= 0)
  {
    answer.linear = IntegrateLinearly(
      input.grid, surface.function, field != nullptr ? field->name : "", options.linear);
  }
  return answer;
}

/// The notes of a report: parts that are left out, and numbers that are not proven.
std::vector<std::string> AnswerNotes(const Answer& answer, double tolerance)
{
  std::vector<std::string> notes = DoubtsOf(answer.found, tolerance);
  notes.insert(notes.end(), answer.more.notes.begin(), answer.more.notes.end());
  return notes;
}

/// The linear pipeline's value of a quantity; none where it has none.
std::optional<double> LinearOf(const Answer& answer, const std::string& quantity)
{
  if (!answer.linear)
  {
    return std::nullopt;
  }
  const LinearIntegral& linear = *answer.linear;
  const auto number = quantity.find(' ');
  const std::string kind = quantity.substr(0, number);
  if (kind == "Area")
  {
    return linear.area;
  }
  if (kind != "Integral" && kind != "Mean")
  {
    return std::nullopt;
  }
  const std::size_t component =
    number == std::string::npos ? 0 : std::stoul(quantity.substr(number + 1));
  if (component >= linear.integrals.size())
  {
    return std::nullopt;
  }
  return kind == "Mean" ? linear.integrals[component] / linear.area : linear.integrals[component];
}

std::string RowText(const Answer& answer, const IntegralRow& row)
{
  std::string text = std::isfinite(row.Error())
    ? fmt::format("{} +- {}", Short(row.Middle(), 15), Short(row.Error(), 2))
    : std::string("not bounded");
  if (const auto linear = LinearOf(answer, row.quantity))
  {
    text += fmt::format(
      "   linear {}, off by {}", Short(*linear, 9), Short(std::fabs(*linear - row.Middle()), 2));
  }
  return text;
}

/// The extreme that a row is about; null where it is about none.
const Extreme* ExtremeOf(const Answer& answer, const IntegralRow& row)
{
  if (!answer.more.extremes)
  {
    return nullptr;
  }
  return row.quantity == "Minimum" ? &answer.more.extremes->extremes.minimum
    : row.quantity == "Maximum"    ? &answer.more.extremes->extremes.maximum
                                   : nullptr;
}

std::int64_t CellOfExtreme(const LoadedModel& input, const Extreme& extreme)
{
  return input.model->SourceCells()[static_cast<std::size_t>(extreme.element)];
}

/// Where the value of a row is; empty where it has no place.
std::string PlaceText(const LoadedModel& input, const Answer& answer, const IntegralRow& row)
{
  const Extreme* const extreme = ExtremeOf(answer, row);
  if (extreme == nullptr)
  {
    return {};
  }
  return fmt::format(" at ({}, {}, {}), element {}", Short(extreme->x.x, 9), Short(extreme->x.y, 9),
    Short(extreme->x.z, 9), CellOfExtreme(input, *extreme));
}

/// A surface's row of a time step.
void AddStepRow(Table& table, const LoadedModel& input, const Answer& answer, double tolerance)
{
  std::vector<std::string> texts;
  texts.reserve(answer.rows.size());
  for (const IntegralRow& row : answer.rows)
  {
    texts.push_back(fmt::format("{} {}", row.quantity, RowText(answer, row)));
  }
  table.Row(fmt::format("step {}", input.step), "time {}: {}", Short(TimeOf(input)), Listed(texts));
  for (const std::string& doubt : AnswerNotes(answer, tolerance))
  {
    table.Row("note", doubt);
  }
}

void PrintAnswer(const LoadedModel& input, const Answer& answer, const IntegralEffort& effort)
{
  Table table;
  table.Row("surface", answer.name);
  const SurfaceIntegral& found = answer.found;
  table.Row(
    "met", "{} elements inside, {} faces; {} boxes", found.elements, found.faces, found.boxes);
  for (const IntegralRow& row : answer.rows)
  {
    table.Row(row.quantity, RowText(answer, row) + PlaceText(input, answer, row));
  }
  for (const HistogramClass& one : answer.more.histogram)
  {
    table.Row("", "{} to {}: {} to {} % of the area", Short(one.from), Short(one.to),
      Rounded(100.0 * one.part.lower, false, 4), Rounded(100.0 * one.part.upper, true, 4));
  }
  for (const std::string& doubt : AnswerNotes(answer, effort.tolerance))
  {
    table.Row("note", doubt);
  }
  table.Print();
}

nlohmann::ordered_json AnswerJson(
  const LoadedModel& input, const Answer& answer, const IntegralEffort& effort)
{
  const SurfaceIntegral& found = answer.found;
  nlohmann::ordered_json summary{ { "surface", answer.name }, { "tolerance_met", found.met },
    { "numeric", found.isNumeric }, { "elements", found.elements }, { "faces", found.faces },
    { "boxes", found.boxes }, { "unresolved_area", found.unresolved },
    { "not_finite", found.notFinite }, { "flat", found.flat }, { "not_valid", found.notValid },
    { "partly_covered", found.covered }, { "notes", AnswerNotes(answer, effort.tolerance) } };
  for (const IntegralRow& row : answer.rows)
  {
    nlohmann::ordered_json entry{ { "quantity", row.quantity }, { "value", row.Middle() },
      { "error_bound", row.Error() }, { "lower", row.value.lower }, { "upper", row.value.upper } };
    if (const auto linear = LinearOf(answer, row.quantity))
    {
      entry["linear"] = *linear;
    }
    if (const Extreme* const extreme = ExtremeOf(answer, row))
    {
      entry.update({ { "at", { extreme->x.x, extreme->x.y, extreme->x.z } },
        { "element", CellOfExtreme(input, *extreme) },
        { "xi", { extreme->xi.x, extreme->xi.y, extreme->xi.z } },
        { "value_at", extreme->value } });
    }
    summary["rows"].push_back(entry);
  }
  for (const HistogramClass& one : answer.more.histogram)
  {
    summary["histogram"].push_back({ { "from", one.from }, { "to", one.to },
      { "lower", one.part.lower }, { "upper", one.part.upper } });
  }
  if (answer.linear)
  {
    summary["linear_triangles"] = answer.linear->triangles;
  }
  return summary;
}

/// Integrates over all surfaces at one time step, calling `visit` for each result. Returns the
/// summary without the results.
nlohmann::ordered_json SolveStep(const LoadedModel& input, const Field* field,
  const IntegrateOptions& options, const std::function<void(const Answer&)>& visit)
{
  const HighOrderModel& model = *input.model;
  nlohmann::ordered_json summary{ { "elements", model.GetMesh().Elements() },
    { "field", field != nullptr ? nlohmann::ordered_json(field->name) : nullptr } };
  AddTime(summary, input);
  for (const IntegralSurface& surface : options.surfaces.Make(model))
  {
    visit(Solve(surface, input, field, options));
  }
  return summary;
}

/// Draws the quantity over time, or of one step the first surface's histogram.
void DrawPlot(const IntegrateOptions& options, const std::string& field,
  const std::vector<TimedRows>& rows, const std::vector<HistogramClass>& histogram)
{
  if (options.input.allSteps)
  {
    options.plot.Write(PlotOfRows(field, options.plotQuantity, rows));
    return;
  }
  if (histogram.empty())
  {
    throw Error("--plot: there is no histogram of the first surface to draw");
  }
  options.plot.Write(PlotOfHistogram(field, histogram));
}

void RunIntegrate(const IntegrateOptions& options, const CommonOptions& common)
{
  if (options.plot.IsAsked() && !options.input.allSteps && options.statistics.classes == 0)
  {
    throw UsageError(
      "--plot: give --time-step all for a quantity over time, or --statistics N for a "
      "histogram");
  }
  options.plot.Check(options.input.files);
  CheckStandardOutput({ options.plot.Name() }, common.json);
  const IntegralEffort effort = options.Effort();
  (void)options.surfaces.Clips(); // which refuses what is none
  if (const std::string other = options.surfaces.NotLinear(); options.linear >= 0 && !other.empty())
  {
    throw UsageError(
      "--linear is for planes, quadrics, tori and boxes, whole; leave it out with " + other);
  }
  Stopwatch stopwatch;
  std::vector<nlohmann::ordered_json> summaries;
  std::vector<Table> tables; // of all steps, by surface
  std::string name;          // of the field, in all steps; empty: there is none
  std::vector<TimedRows> rows;
  std::vector<HistogramClass> histogram; // of the first surface
  // An iso-surface and a correlation may need other fields; then all fields are loaded.
  const bool needsAll = options.surfaces.HasIsoSurfaces() || !options.statistics.with.empty();
  ForEachStep(options.input, needsAll ? std::string() : options.field, stopwatch,
    [&](const LoadedModel& input)
    {
      const bool isFirst = summaries.empty();
      if (isFirst)
      {
        WarnOfDiagnostics(input);
        name = options.field.empty() && !input.model->Fields().empty()
          ? FieldOrFirst(*input.model, {}).name
          : options.field;
      }
      std::size_t surface = 0;
      auto answers = nlohmann::ordered_json::array();
      nlohmann::ordered_json summary =
        SolveStep(input, name.empty() ? nullptr : &input.model->GetField(name), options,
          [&](const Answer& answer)
          {
            answers.push_back(AnswerJson(input, answer, effort));
            rows.push_back({ answer.name, TimeOf(input), answer.rows });
            histogram = rows.size() == 1 ? answer.more.histogram : histogram;
            if (!common.json && !options.input.allSteps)
            {
              PrintAnswer(input, answer, effort);
              return;
            }
            if (isFirst)
            {
              tables.emplace_back().Row("surface", answer.name);
            }
            AddStepRow(tables[surface++], input, answer, effort.tolerance);
          });
      summary["surfaces"] = std::move(answers);
      summaries.push_back(std::move(summary));
      stopwatch.Stage("integrate");
    });
  if (options.plot.IsAsked())
  {
    DrawPlot(options, name, rows, histogram);
    stopwatch.Stage("write");
  }
  if (common.json)
  {
    nlohmann::ordered_json summary = summaries.front();
    if (options.input.allSteps)
    {
      summary = { { "steps", summaries } };
    }
    summary["seconds"] = ToJson(stopwatch);
    Print(summary);
    return;
  }
  std::ranges::for_each(tables, [](const Table& one) { one.Print(); });
  Table table;
  AddStages(table, stopwatch);
  table.Print();
}
} // namespace

void AddIntegrateCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<IntegrateOptions>();
  CLI::App& command = AddCommand(program, "integrate",
    "Area, integral, mean and flux of a field over a cut or the boundary, with proven error bounds",
    [options, &common, &action]
    { action = [options, &common] { RunIntegrate(*options, common); }; });
  options->input.mayBeAll = true;
  options->input.AddTo(command);
  Bind(command, "--field", options->field);
  options->surfaces.AddTo(command);
  Bind(command, "--tolerance", options->tolerance);
  Bind(command, "--seconds", options->seconds);
  Bind(command, "--linear", options->linear);
  options->plot.AddTo(command);
  Bind(command, "--plot-quantity", options->plotQuantity);
  Bind(command, "--norms", options->statistics.norms);
  Bind(command, "--extremes", options->statistics.extremes);
  Bind(command, "--statistics", options->statistics.classes);
  Bind(command, "--correlate", options->statistics.with);
}
} // namespace pixelexact
