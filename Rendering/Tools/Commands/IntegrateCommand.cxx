// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/Options.h"
#include "Base/Report.h"
#include "Commands/IntegralSurfaces.h"
#include "Cuts/IntegralPieces.h"
#include "Cuts/IntegralRows.h"
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

  [[nodiscard]] IntegralEffort Effort() const
  {
    IntegralEffort effort;
    effort.tolerance = tolerance.value_or(effort.tolerance);
    effort.seconds = seconds.value_or(effort.seconds);
    return effort;
  }
};

/// The results of one surface.
struct Answer
{
  std::string name;
  SurfaceIntegral found;
  std::vector<IntegralRow> rows;
  std::optional<LinearIntegral> linear;
};

Answer Solve(const IntegralSurface& surface, const LoadedModel& input, const Field* field,
  const IntegrateOptions& options)
{
  const HighOrderModel& model = *input.model;
  IntegralQuestion question{ model.GetMesh(), field, nullptr };
  Answer answer{ surface.name, {}, {}, std::nullopt };
  const std::vector<ImplicitPolynomial> clips = options.surfaces.Clips();
  question.clips = clips;
  if (surface.iso)
  {
    const IsoChoice iso = Resolve(*surface.iso, model);
    const IsoValueSurface cut(model.GetField(iso.field), iso.component, iso.value);
    question.cut = &cut;
    answer.found = IntegrateCut(question, model.GetLocator(), model.Faces(), options.Effort());
    question.cut = nullptr;
  }
  else if (surface.boundary)
  {
    answer.found = IntegrateBoundary(question, surface.attributes, model, options.Effort());
  }
  else
  {
    answer.found = IntegratePatches(question, surface.patches, clips, model, options.Effort());
  }
  answer.rows = RowsOf(question, answer.found);
  if (options.linear >= 0)
  {
    answer.linear = IntegrateLinearly(
      input.grid, surface.function, field != nullptr ? field->name : "", options.linear);
  }
  return answer;
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
  const std::size_t component =
    number == std::string::npos ? 0 : std::stoul(quantity.substr(number + 1));
  if (kind == "Area")
  {
    return linear.area;
  }
  if (kind == "Flux" || component >= linear.integrals.size())
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
  for (const std::string& doubt : DoubtsOf(answer.found, tolerance))
  {
    table.Row("note", doubt);
  }
}

void PrintAnswer(const Answer& answer, const IntegralEffort& effort)
{
  Table table;
  table.Row("surface", answer.name);
  const SurfaceIntegral& found = answer.found;
  table.Row(
    "met", "{} elements inside, {} faces; {} boxes", found.elements, found.faces, found.boxes);
  for (const IntegralRow& row : answer.rows)
  {
    table.Row(row.quantity, RowText(answer, row));
  }
  for (const std::string& doubt : DoubtsOf(found, effort.tolerance))
  {
    table.Row("note", doubt);
  }
  table.Print();
}

nlohmann::ordered_json AnswerJson(const Answer& answer, const IntegralEffort& effort)
{
  const SurfaceIntegral& found = answer.found;
  nlohmann::ordered_json summary{ { "surface", answer.name }, { "tolerance_met", found.met },
    { "numeric", found.isNumeric }, { "elements", found.elements }, { "faces", found.faces },
    { "boxes", found.boxes }, { "unresolved_area", found.unresolved },
    { "not_finite", found.notFinite }, { "flat", found.flat }, { "not_valid", found.notValid },
    { "partly_covered", found.covered }, { "notes", DoubtsOf(found, effort.tolerance) } };
  for (const IntegralRow& row : answer.rows)
  {
    nlohmann::ordered_json entry{ { "quantity", row.quantity }, { "value", row.Middle() },
      { "error_bound", row.Error() }, { "lower", row.value.lower }, { "upper", row.value.upper } };
    if (const auto linear = LinearOf(answer, row.quantity))
    {
      entry["linear"] = *linear;
    }
    summary["rows"].push_back(entry);
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

void RunIntegrate(const IntegrateOptions& options, const CommonOptions& common)
{
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
  // An iso-surface may belong to another field than the integrand; then all fields are loaded.
  ForEachStep(options.input, options.surfaces.HasIsoSurfaces() ? std::string() : options.field,
    stopwatch,
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
            answers.push_back(AnswerJson(answer, effort));
            if (!common.json && !options.input.allSteps)
            {
              PrintAnswer(answer, effort);
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
}
} // namespace pixelexact
