// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/NormFacts.h"

#include "Base/Csv.h"
#include "Base/Output.h"
#include "Scene/Model.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Counted.h"
#include "Formats/Slab.h"

#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr std::size_t kMaxWorstElements = 5;

std::string EstimateText(const Estimate& number)
{
  return fmt::format("{} +- {} (numeric)", Short(number.value, 12), Short(number.error, 2));
}

std::int64_t NormCellOf(const LoadedModel& input, int element)
{
  return input.model->SourceCells()[static_cast<std::size_t>(element)];
}

double SquarePart(const FieldNorms& norms, int element)
{
  const double total = norms.l2.value * norms.l2.value;
  return total > 0.0 ? norms.elements[static_cast<std::size_t>(element)].square.value / total : 0.0;
}

std::vector<std::string> NormNotes(const FieldNorms& norms)
{
  std::vector<std::string> notes;
  if (norms.notFinite > 0)
  {
    notes.push_back(
      "not finite in " + Counted(norms.notFinite, "element") + ", which are left out");
  }
  if (norms.folded > 0)
  {
    notes.push_back(
      "det J <= 0 in " + Counted(norms.folded, "element") + ", over which |det J| is integrated");
  }
  if (!norms.met)
  {
    notes.emplace_back("the errors are larger than requested: the work budget is exhausted");
  }
  return notes;
}

nlohmann::ordered_json EstimateJson(const Estimate& number)
{
  return { { "value", number.value }, { "error_estimate", number.error } };
}
} // namespace

NormFacts FindNormFacts(const LoadedModel& input, const std::vector<std::string>& names)
{
  const auto begin = std::chrono::steady_clock::now();
  const HighOrderModel& model = *input.model;
  model.RequireSolids("--norms");
  const std::optional<Slab> slab = SlabOf(input.grid);
  NormFacts facts;
  facts.isPlane = slab.has_value();
  NormEffort effort;
  for (const Field& field : model.Fields())
  {
    effort.order = std::max(effort.order, OrderRange(field.values)[1]);
  }
  ProgressLine line("integrating");
  double done = 0.0;
  for (const std::string& name : names)
  {
    const Field& field = model.GetField(name);
    const auto progress = [&](double part)
    { line((done + 0.5 * part) / static_cast<double>(names.size())); };
    NormsOfField& found = facts.fields.emplace_back();
    found.name = field.name;
    found.norms = FindNorms(model.GetMesh(), field, slab ? slab->thickness : 0.0, effort, progress);
    done += 0.5;
    found.largest = LargestMagnitude(model.GetMesh(), field, progress);
    done += 0.5;
    found.mostOfSquare = CountWithPart(found.norms, kCountedPart);
  }
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return facts;
}

void AddTo(Table& table, const LoadedModel& input, const NormFacts& facts)
{
  std::string name = "norms";
  for (const NormsOfField& field : facts.fields)
  {
    const FieldNorms& norms = field.norms;
    table.Row(name, "{} over {} {}", field.name, facts.isPlane ? "an area of" : "a volume of",
      EstimateText(norms.volume));
    name.clear();
    table.Row("", "  L1    {}", EstimateText(norms.l1));
    table.Row("", "  L2    {}", EstimateText(norms.l2));
    if (field.largest)
    {
      table.Row("", "  Linf  proven between {} and {}", Rounded(field.largest->lower, false, 12),
        Rounded(field.largest->upper, true, 12));
    }
    else
    {
      table.Row("", "  Linf  {} at the samples (numeric)", Short(norms.largest, 12));
    }
    for (std::size_t c = 0; c < norms.integrals.size(); ++c)
    {
      table.Row("", "  integral{}  {}",
        norms.integrals.size() > 1 ? fmt::format(" {}", c) : std::string(),
        EstimateText(norms.integrals[c]));
    }
    if (norms.l2.value > 0.0)
    {
      table.Row("", "  90 % of L2 squared are in {} of {}", field.mostOfSquare,
        Counted(static_cast<std::int64_t>(norms.elements.size()), "element"));
      const std::vector<int> order = OrderBySquare(norms);
      for (std::size_t k = 0; k < std::min(order.size(), kMaxWorstElements); ++k)
      {
        table.Row("", "    element {}: {} %, largest {}", NormCellOf(input, order[k]),
          Short(100.0 * SquarePart(norms, order[k]), 3),
          Short(norms.elements[static_cast<std::size_t>(order[k])].largest));
      }
    }
    for (const std::string& note : NormNotes(norms))
    {
      table.Row("", "  " + note);
    }
  }
  table.Row("", "integrated in {} s", Short(facts.seconds));
}

void AddTo(nlohmann::ordered_json& summary, const LoadedModel& input, const NormFacts& facts)
{
  auto fields = nlohmann::ordered_json::array();
  for (const NormsOfField& field : facts.fields)
  {
    const FieldNorms& norms = field.norms;
    nlohmann::ordered_json entry{ { "field", field.name },
      { facts.isPlane ? "area" : "volume", EstimateJson(norms.volume) },
      { "l1", EstimateJson(norms.l1) }, { "l2", EstimateJson(norms.l2) } };
    entry["linf"] = { { "proven", field.largest.has_value() } };
    if (field.largest)
    {
      entry["linf"].update(
        { { "attained", field.largest->lower }, { "bound", field.largest->upper } });
    }
    entry["linf"]["largest_sample"] = norms.largest;
    entry["linf"]["element"] =
      norms.largestElement < 0 ? -1 : NormCellOf(input, norms.largestElement);
    for (const Estimate& integral : norms.integrals)
    {
      entry["integrals"].push_back(EstimateJson(integral));
    }
    entry.update({ { "elements_with_90_percent", field.mostOfSquare },
      { "tolerance_met", norms.met }, { "boxes", norms.boxes },
      { "not_finite_elements", norms.notFinite }, { "folded_elements", norms.folded } });
    const std::vector<int> order = OrderBySquare(norms);
    auto worst = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < std::min(order.size(), kMaxWorstElements); ++k)
    {
      worst.push_back({ { "element", NormCellOf(input, order[k]) },
        { "part_of_square", SquarePart(norms, order[k]) },
        { "largest_sample", norms.elements[static_cast<std::size_t>(order[k])].largest } });
    }
    entry["worst"] = std::move(worst);
    fields.push_back(std::move(entry));
  }
  summary["norms"] = { { "fields", std::move(fields) }, { "seconds", facts.seconds } };
}

void WriteNorms(const std::string& file, const LoadedModel& input, const NormFacts& facts)
{
  std::string text = fmt::format("field,element,{},l1,l2,l2_error_estimate,largest_sample,"
                                 "part_of_square,sum_of_parts\n",
    facts.isPlane ? "area" : "volume");
  for (const NormsOfField& field : facts.fields)
  {
    double sum = 0.0;
    for (const int e : OrderBySquare(field.norms))
    {
      const ElementNorms& one = field.norms.elements[static_cast<std::size_t>(e)];
      const double part = SquarePart(field.norms, e);
      sum += part;
      const double l2 = std::sqrt(one.square.value);
      const double error = std::sqrt(one.square.value + one.square.error) - l2;
      text += one.isFinite
        ? fmt::format("{},{},{},{},{},{},{},{},{}\n", CsvField(field.name), NormCellOf(input, e),
            one.volume.value, one.absolute.value, l2, error, one.largest, part, std::min(sum, 1.0))
        : fmt::format(
            "{},{},nan,nan,nan,nan,nan,nan,nan\n", CsvField(field.name), NormCellOf(input, e));
    }
  }
  WriteBytes(file, text);
}
} // namespace pixelexact
