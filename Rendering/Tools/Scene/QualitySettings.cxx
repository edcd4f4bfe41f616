// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/QualitySettings.h"

#include "Base/Command.h"
#include "Base/Report.h"
#include "Scene/Shot.h"

#include "Grids/GridCopies.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace pixelexact
{
void QualityOptions::AddTo(CLI::App& command, ShotOptions& shot)
{
  Bind(command, "--stride", stride_);
  Bind(command, "--truncate-order", shot.input.truncateOrder);
}

void QualityOptions::Check(const CLI::App& command) const
{
  if (stride_ == 1)
  {
    return;
  }
  constexpr std::array<std::string_view, 9> kOfPixels{ "--contours", "--contours-output",
    "--samples", "--edges", "--outlines", "--show", "--owners", "--show-undecided",
    "--mesh-outline" };
  for (const std::string& name : OptionsGiven(command))
  {
    if (std::ranges::find(kOfPixels, name) != kOfPixels.end())
    {
      throw UsageError("--stride: " + name + " is of each pixel; leave one of them out");
    }
  }
}

std::vector<TruncatedField> TruncatedFields(const Shot& shot)
{
  std::vector<TruncatedField> fields;
  for (const Layer& layer : shot.scene.layers)
  {
    const auto known = layer.field != nullptr ? shot.input.truncations.find(layer.field->name)
                                              : shot.input.truncations.end();
    if (layer.field != nullptr && layer.field->function != nullptr &&
      !shot.input.truncations.empty())
    {
      throw Error("--truncate-order is for fields, and '" + layer.field->name +
        "' is an expression of them; leave out one of both");
    }
    if (known == shot.input.truncations.end())
    {
      continue;
    }
    const std::string component = ComponentName(layer);
    const bool isListed = std::ranges::any_of(fields,
      [&](const TruncatedField& field)
      { return field.name == layer.field->name && field.component == component; });
    if (isListed)
    {
      continue;
    }
    const Truncation& truncation = *known->second;
    ProgressLine line("bounding");
    const double change = LargestChange(shot.input.model->GetMesh(), truncation, layer.component,
      [&line](double part) { line(part); });
    fields.push_back({ layer.field->name, component, truncation.Order(), truncation.Modes(),
      truncation.DroppedModes(), change });
  }
  return fields;
}

std::vector<std::string> QualityFacts::Texts() const
{
  std::vector<std::string> texts;
  if (stride > 1)
  {
    texts.push_back(fmt::format("stride {0}: each {0} x {0} pixels show their middle one", stride));
  }
  for (const TruncatedField& field : fields)
  {
    const std::string name =
      field.name + (field.component == "value" ? std::string() : " " + field.component);
    texts.push_back(fmt::format("{} truncated to order {}: {} of {} modes dropped; values are {}",
      name, field.order, field.dropped, field.modes,
      std::isfinite(field.change) ? "off by " + Short(field.change) + " at most"
                                  : "off by an amount that could not be bounded"));
  }
  return texts;
}

void QualityFacts::AddTo(Table& table) const
{
  std::string name = "given up";
  for (const std::string& text : Texts())
  {
    table.Row(name, text);
    name.clear();
  }
}

void QualityFacts::AddTo(nlohmann::ordered_json& summary) const
{
  if (stride > 1)
  {
    summary["stride"] = stride;
  }
  for (const TruncatedField& field : fields)
  {
    summary["truncated"].push_back({ { "field", field.name }, { "component", field.component },
      { "order", field.order }, { "modes", field.modes }, { "dropped", field.dropped },
      { "largest_change", field.change } });
  }
}

void Truncate(LoadedModel& input, int order)
{
  std::vector<Truncation> truncations;
  for (const Field& field : input.model->Fields())
  {
    truncations.emplace_back(field, order);
  }
  input.grid = WithTruncated(input.grid, truncations);
  // The old model is kept until the new one exists, which takes over its mesh and locator.
  input.model = HighOrderModel::From(input.grid);
  for (Truncation& truncation : truncations)
  {
    const std::string name = truncation.Kept().name;
    input.truncations[name] = std::make_shared<const Truncation>(std::move(truncation));
  }
}
} // namespace pixelexact
