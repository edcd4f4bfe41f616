// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/ExtremeFacts.h"

#include "Scene/Model.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Counted.h"
#include "Core/Expression/Expression.h"
#include "Formats/Slab.h"
#include "Grids/Continuity.h"

#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>

namespace pixelexact
{
namespace
{
std::int64_t CellOf(const LoadedModel& input, const Extreme& extreme)
{
  return extreme.element < 0
    ? -1
    : input.model->SourceCells()[static_cast<std::size_t>(extreme.element)];
}

std::string TripleText(const Vec3& place, int digits)
{
  return fmt::format(
    "({}, {}, {})", Short(place.x, digits), Short(place.y, digits), Short(place.z, digits));
}

void AddExtreme(Table& table, const LoadedModel& input, const Extreme& extreme, bool isMinimum)
{
  const char* const name = isMinimum ? "minimum" : "maximum";
  if (extreme.element < 0)
  {
    table.Row("", "  {}: no value is finite", name);
    return;
  }
  table.Row("", "  {} {} at {}, element {}, xi {}", name, Short(extreme.value, 15),
    TripleText(extreme.x, 12), CellOf(input, extreme), TripleText(extreme.xi, 9));
  if (!std::isfinite(extreme.bound))
  {
    table.Row("", "    not proven: no bound was found");
    return;
  }
  const double outer = extreme.bound;
  const double inner = extreme.attained;
  table.Row("", "    proven between {} and {}, gap {}", Rounded(std::min(outer, inner), false, 15),
    Rounded(std::max(outer, inner), true, 15), Rounded(extreme.gap, true, 2));
}

std::string ScalarName(const ExtremesOfField& field, std::size_t k)
{
  if (field.extremes.size() == 1)
  {
    return field.name;
  }
  return k + 1 == field.extremes.size() ? "|" + field.name + "|"
                                        : fmt::format("{} (component {})", field.name, k);
}

std::vector<std::string> NotesOf(const Extremes& extremes)
{
  std::vector<std::string> notes;
  if (extremes.notFinite > 0)
  {
    notes.push_back(
      "not finite in " + Counted(extremes.notFinite, "element") + ", which are left out");
  }
  if (extremes.unbounded > 0)
  {
    notes.push_back("no bound found in " + Counted(extremes.unbounded, "element"));
  }
  else if (!extremes.met)
  {
    notes.emplace_back("the gap is larger than requested: the work budget is exhausted");
  }
  return notes;
}

nlohmann::ordered_json ExtremeJson(const LoadedModel& input, const Extreme& extreme)
{
  // Numbers that are not known become null.
  return { { "value", extreme.value }, { "bound", extreme.bound }, { "attained", extreme.attained },
    { "gap", extreme.gap }, { "position", { extreme.x.x, extreme.x.y, extreme.x.z } },
    { "element", CellOf(input, extreme) }, { "xi", { extreme.xi.x, extreme.xi.y, extreme.xi.z } } };
}

nlohmann::ordered_json ExtremesJson(const LoadedModel& input, const Extremes& extremes)
{
  return { { "minimum", ExtremeJson(input, extremes.minimum) },
    { "maximum", ExtremeJson(input, extremes.maximum) }, { "tolerance_met", extremes.met },
    { "boxes", extremes.boxes }, { "not_finite_elements", extremes.notFinite },
    { "unbounded_elements", extremes.unbounded } };
}
} // namespace

ExtremeFacts FindExtremeFacts(const LoadedModel& input, const std::vector<std::string>& names)
{
  const auto begin = std::chrono::steady_clock::now();
  const HighOrderModel& model = *input.model;
  const Mesh& mesh = model.GetMesh();
  const bool isPlane = SlabOf(input.grid).has_value();
  std::vector<const Field*> fields;
  double steps = 1.0;
  for (const std::string& name : names)
  {
    const Field& field = model.GetField(name);
    RequireAnswer({ Quantity::Component, &field });
    RequireSurfaceRange(mesh, field);
    fields.push_back(&field);
    steps += field.values.components > 1 ? field.values.components + 1.0 : 1.0;
  }
  ProgressLine line("finding extremes");
  double done = 0.0;
  const auto next = [&]() -> RangeProgress
  {
    const double from = done / steps;
    done += 1.0;
    return [&line, from, steps](double part) { line(from + part / steps); };
  };
  ExtremeFacts facts;
  for (const auto& verdict : ValidityOf(mesh, RangeEffort{}, next()))
  {
    ++facts.count[static_cast<std::size_t>(verdict.validity)];
  }
  for (const Field* const field : fields)
  {
    ExtremesOfField& found = facts.fields.emplace_back();
    found.name = field->name;
    const Continuity across = CompareAcrossElements(mesh, std::span(field, 1)).front();
    found.discontinuous = across.comparisons > 0 && !across.IsContinuous();
    const int components = field->values.components;
    for (int c = 0; c < components; ++c)
    {
      found.extremes.push_back(
        FindExtremes(mesh, { Quantity::Component, field, c }, isPlane, kExtremeEffort, next()));
    }
    if (components > 1)
    {
      found.extremes.push_back(
        FindExtremes(mesh, { Quantity::Magnitude, field }, isPlane, kExtremeEffort, next()));
    }
  }
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return facts;
}

void AddTo(Table& table, const LoadedModel& input, const ExtremeFacts& facts)
{
  std::string name = "extremes";
  for (const ExtremesOfField& field : facts.fields)
  {
    for (std::size_t k = 0; k < field.extremes.size(); ++k)
    {
      const Extremes& extremes = field.extremes[k];
      table.Row(name, ScalarName(field, k));
      name.clear();
      AddExtreme(table, input, extremes.minimum, true);
      AddExtreme(table, input, extremes.maximum, false);
      for (const std::string& note : NotesOf(extremes))
      {
        table.Row("", "  " + note);
      }
    }
    if (field.discontinuous)
    {
      table.Row("",
        "  discontinuous: values are those of the named elements, on faces those of "
        "neighbours differ");
    }
  }
  const auto countOf = [&facts](Validity validity)
  { return facts.count[static_cast<std::size_t>(validity)]; };
  if (countOf(Validity::Inverted) + countOf(Validity::Undecided) > 0)
  {
    table.Row("", "{} inverted, {} undecided: other elements may hold the same points",
      Counted(countOf(Validity::Inverted), "element"), countOf(Validity::Undecided));
  }
  table.Row("", "found in {} s", Short(facts.seconds));
}

void AddTo(nlohmann::ordered_json& summary, const LoadedModel& input, const ExtremeFacts& facts)
{
  auto fields = nlohmann::ordered_json::array();
  for (const ExtremesOfField& field : facts.fields)
  {
    nlohmann::ordered_json entry{ { "field", field.name },
      { "discontinuous", field.discontinuous } };
    const std::size_t components = std::max<std::size_t>(field.extremes.size() - 1, 1);
    for (std::size_t k = 0; k < components; ++k)
    {
      entry["components"].push_back(ExtremesJson(input, field.extremes[k]));
    }
    if (field.extremes.size() > 1)
    {
      entry["magnitude"] = ExtremesJson(input, field.extremes.back());
    }
    fields.push_back(std::move(entry));
  }
  summary["extremes"] = { { "fields", std::move(fields) } };
  for (const Validity validity : { Validity::Valid, Validity::Inverted, Validity::Undecided })
  {
    summary["extremes"][std::string(Name(validity)) + "_elements"] =
      facts.count[static_cast<std::size_t>(validity)];
  }
  summary["extremes"]["seconds"] = facts.seconds;
}
} // namespace pixelexact
