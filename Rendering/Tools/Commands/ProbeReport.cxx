// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/ProbeReport.h"

#include "Base/Report.h"
#include "Input/Input.h"
#include "Scene/Model.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace pixelexact
{
namespace
{
void AddEnclosures(nlohmann::ordered_json& summary, const ProbeSamples& samples)
{
  const EnclosureWidths widths = MeasureEnclosures(samples);
  summary["enclosures"] = { { "median_width", widths.median }, { "largest_width", widths.largest },
    { "unbounded", widths.unbounded } };
}

void AddEnclosures(Table& table, const ProbeSamples& samples, const std::string& of)
{
  const EnclosureWidths widths = MeasureEnclosures(samples);
  // Two digits suffice for a width.
  table.Row("enclosures", "{}median width {}, largest {} of the range of values", of,
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

nlohmann::ordered_json ProbedJson(const Field* field, const ProbedField& probed, bool enclosures)
{
  nlohmann::ordered_json facts{
    { "field", field != nullptr ? nlohmann::ordered_json(field->name) : nlohmann::ordered_json() },
    { "components", probed.samples.components },
    { "non_finite", CountProbes(probed.samples).nonFinite }
  };
  if (enclosures)
  {
    AddEnclosures(facts, probed.samples);
  }
  return facts;
}
} // namespace

nlohmann::ordered_json ProbeJson(const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns)
{
  const ProbeSamples& first = probed.front().samples;
  const ProbeCounts counts = CountProbes(first);
  nlohmann::ordered_json summary =
    ProbedJson(fields.empty() ? nullptr : fields.front(), probed.front(), columns.enclosures);
  AddTime(summary, input);
  summary.update({ { "points", first.element.size() }, { "inside", counts.inside },
    { "outside", counts.outside }, { "unknown", counts.unknown } });
  if (columns.owners)
  {
    AddCoverage(summary, first);
  }
  if (fields.size() > 1)
  {
    summary["fields"] = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < fields.size(); ++k)
    {
      summary["fields"].push_back(ProbedJson(fields[k], probed[k], columns.enclosures));
    }
  }
  return summary;
}

void AddTo(Table& table, const LoadedModel& input, const std::vector<const Field*>& fields,
  const std::vector<ProbedField>& probed, const ProbeColumns& columns)
{
  const ProbeSamples& first = probed.front().samples;
  const ProbeCounts counts = CountProbes(first);
  for (std::size_t k = 0; k < fields.size(); ++k)
  {
    table.Row(k == 0 ? "field" : "", fields[k]->name + FieldKind(*fields[k]));
  }
  if (fields.empty())
  {
    table.Row("field", "none");
  }
  AddTime(table, input);
  table.Row("points", "{}: {} inside, {} outside, {} unknown", first.element.size(), counts.inside,
    counts.outside, counts.unknown);
  for (const ProbedField& field : probed)
  {
    const std::string of = probed.size() > 1 ? field.name + ": " : std::string();
    if (const std::size_t count = CountProbes(field.samples).nonFinite; count > 0)
    {
      table.Row("non-finite", "{}{} of the values inside", of, count);
    }
    if (columns.enclosures)
    {
      AddEnclosures(table, field.samples, of);
    }
  }
  if (columns.owners)
  {
    AddCoverage(table, first);
  }
}
} // namespace pixelexact
