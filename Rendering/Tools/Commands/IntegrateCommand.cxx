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

#include <cmath>
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

void PrintAnswer(const Answer& answer, const IntegralEffort& effort)
{
  Table table;
  table.Row("surface", answer.name);
  const SurfaceIntegral& found = answer.found;
  table.Row(
    "met", "{} elements inside, {} faces; {} boxes", found.elements, found.faces, found.boxes);
  for (const IntegralRow& row : answer.rows)
  {
    std::string text = std::isfinite(row.Error())
      ? fmt::format("{} +- {}", Short(row.Middle(), 15), Short(row.Error(), 2))
      : std::string("not bounded");
    if (const auto linear = LinearOf(answer, row.quantity))
    {
      text += fmt::format(
        "   linear {}, off by {}", Short(*linear, 9), Short(std::fabs(*linear - row.Middle()), 2));
    }
    table.Row(row.quantity, text);
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
  // An iso-surface may belong to another field than the integrand; then all fields are loaded.
  const LoadedModel input = LoadModel(
    options.input, options.surfaces.HasIsoSurfaces() ? std::string() : options.field, stopwatch);
  WarnOfDiagnostics(input);
  const HighOrderModel& model = *input.model;
  const Field* const field =
    model.Fields().empty() && options.field.empty() ? nullptr : &FieldOrFirst(model, options.field);
  nlohmann::ordered_json summary{ { "elements", model.GetMesh().Elements() },
    { "field", field != nullptr ? nlohmann::ordered_json(field->name) : nullptr } };
  AddTime(summary, input);
  for (const IntegralSurface& surface : options.surfaces.Make(BoxOf(model)))
  {
    const Answer answer = Solve(surface, input, field, options);
    if (common.json)
    {
      summary["surfaces"].push_back(AnswerJson(answer, effort));
    }
    else
    {
      PrintAnswer(answer, effort);
    }
  }
  stopwatch.Stage("integrate");
  if (common.json)
  {
    summary["seconds"] = ToJson(stopwatch);
    Print(summary);
    return;
  }
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
  options->input.AddTo(command);
  Bind(command, "--field", options->field);
  options->surfaces.AddTo(command);
  Bind(command, "--tolerance", options->tolerance);
  Bind(command, "--seconds", options->seconds);
  Bind(command, "--linear", options->linear);
}
} // namespace pixelexact
