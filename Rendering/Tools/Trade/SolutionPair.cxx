// SPDX-License-Identifier: BSD-3-Clause
#include "Trade/SolutionPair.h"

#include "Base/Report.h"
#include "Scene/Shot.h"
#include "Scene/ShotAppearance.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Error.h"

#include <fmt/format.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <filesystem>
#include <functional>

namespace pixelexact
{
namespace
{
const Field& FieldOf(const LoadedModel& input, const std::string& given, const std::string& usual,
  const std::string& name)
{
  const HighOrderModel& model = *input.model;
  if (given.empty() && model.FindField(usual) == nullptr && model.Fields().size() == 1)
  {
    return model.Fields().front();
  }
  try
  {
    return model.GetField(given.empty() ? usual : given);
  }
  catch (const Error& error)
  {
    throw Error("--with '" + name + "': " + error.what() +
      (given.empty() ? "; choose one with --with-field" : ""));
  }
}
} // namespace

std::string SolutionName(const InputRequest& request, const LoadedModel& input)
{
  const std::string file = std::filesystem::path(request.files.back()).filename().string();
  return SolutionName(file, request, input);
}

OtherSolution LoadOther(
  const InputRequest& request, const std::string& fieldName, const Shot& shot, Stopwatch& stopwatch)
{
  const Field& first = *shot.scene.layers.front().field;
  OtherSolution other;
  // Loads all fields where the name may be missing.
  other.input =
    LoadModel(request, fieldName.empty() ? first.name : fieldName, stopwatch, shot.input.grid);
  WarnOfDiagnostics(other.input);
  other.name = SolutionName(request, other.input);
  other.field = &FieldOf(other.input, fieldName, first.name, other.name);
  if (other.field->values.components != first.values.components)
  {
    throw Error("--with '" + other.name + "': field '" + other.field->name + "'" +
      FieldKind(*other.field) + " is compared with '" + first.name + "'" + FieldKind(first) +
      "; both need as many components: choose another with --with-field");
  }
  if (fieldName.empty() && other.field->name != first.name)
  {
    Note("field '" + other.field->name + "' of '" + other.name +
      "', its only one, is compared with '" + first.name + "'");
  }
  return other;
}

FieldDifference TraceDifferenceOf(
  const ColorOptions& colors, const Shot& shot, const OtherSolution& other)
{
  const Layer& layer = shot.scene.layers.front();
  const DifferenceScene scene{ { shot.scene.locator, layer.field }, other.Of(), layer.surface,
    layer.component, shot.scene.kept };
  ProgressLine line("comparing");
  return TraceDifference(
    scene, shot.MakeCamera(), NeedsOf(ViewOf(colors, nullptr, shot)), true, std::ref(line));
}

SolutionSize SizeOf(const LoadedModel& input, const Field& field)
{
  SolutionSize size;
  size.elements = input.model->GetMesh().Elements();
  size.orders = OrderRange(field.values);
  size.dimensions = SlabOf(input.grid) ? 2 : 3;
  for (const std::int32_t space : field.values.spaceOf)
  {
    size.modes += field.values.spaces[static_cast<std::size_t>(space)].Modes();
  }
  size.length =
    size.elements > 0 ? std::pow(static_cast<double>(size.elements), -1.0 / size.dimensions) : 0.0;
  return size;
}
} // namespace pixelexact
