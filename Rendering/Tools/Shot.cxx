// SPDX-License-Identifier: BSD-3-Clause
#include "Shot.h"

#include "Command.h"
#include "Report.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include <vtkUnstructuredGrid.h>

#include <charconv>

namespace pixelexact
{
namespace
{
int ParseComponent(const std::string& text)
{
  int component = 0;
  const char* end = text.data() + text.size();
  const auto [last, failure] = std::from_chars(text.data(), end, component);
  if (text == "magnitude")
  {
    return Scene::kMagnitude;
  }
  if (failure != std::errc() || last != end || component < 0)
  {
    throw CLI::ValidationError(
      "--component", "expected 'magnitude' or a number from 0, got '" + text + "'");
  }
  return component;
}
} // namespace

void ShotOptions::AddTo(CLI::App& command)
{
  input.AddTo(command);
  command.add_option("--field", field, "Name of the field")->required()->type_name("NAME");
  command
    .add_option_function<std::string>(
      "--component", [this](const std::string& text) { component = ParseComponent(text); },
      "Component of a vector field, counted from 0, or its magnitude (default)")
    ->type_name("magnitude|i");
  command
    .add_option_function<std::string>(
      "--size", [this](const std::string& text) { size = ParseSize("--size", text); },
      "Size of the image in pixels (default: 1000x1000)")
    ->type_name("WxH");
  command
    .add_option_function<std::string>(
      "--precision",
      [this](const std::string& text)
      { precision = text == "float" ? Precision::Float : Precision::Double; },
      "What values are computed in (default: double); what float costs is told")
    ->check(CLI::IsMember({ "double", "float" }));
  surfaces.AddTo(command);
  camera.AddTo(command);
  colors.AddTo(command);
}

Shot Prepare(const ShotOptions& options, Stopwatch& stopwatch)
{
  options.camera.Check();
  options.colors.Check();
  Shot shot;
  shot.size = options.size;
  shot.scene.surfaces = options.surfaces.Make();
  shot.input = LoadModel(options.input, options.field, stopwatch);
  WarnOfDiagnostics(shot.input);
  const HighOrderModel& model = *shot.input.model;
  shot.scene.field = &FieldNamed(model, options.field);
  const int components = shot.scene.field->values.components;
  shot.scene.component = options.component.value_or(components == 1 ? 0 : Scene::kMagnitude);
  if (shot.scene.component >= components)
  {
    throw Error("--component: field '" + options.field + "' has " + std::to_string(components) +
      (components == 1 ? " component" : " components") + ", counted from 0");
  }
  shot.scene.precision = options.precision;
  shot.scene.locator = &model.GetLocator();
  stopwatch.Stage("bounds+bvh");

  Box3 box = shot.scene.locator->Bounds();
  if (model.GetMesh().Elements() == 0)
  {
    // Any camera sees all of nothing.
    box = { Vec3(-1.0), Vec3(1.0) };
  }
  const Vec3 normal = shot.scene.surfaces.front()->Normal(0.5 * (box.lower + box.upper));
  shot.view = options.camera.Make(box, normal, shot.size);
  return shot;
}

std::string ComponentName(const Scene& scene)
{
  if (scene.component == Scene::kMagnitude)
  {
    return "magnitude";
  }
  return scene.field->values.components == 1 ? "value" : std::to_string(scene.component);
}
} // namespace pixelexact
