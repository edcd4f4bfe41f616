// SPDX-License-Identifier: BSD-3-Clause
#include "Shot.h"

#include "Numbers.h"
#include "Report.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include <vtkUnstructuredGrid.h>

namespace pixelexact
{
namespace
{
int ParseComponent(const std::string& text)
{
  int component = 0;
  if (text == "magnitude")
  {
    return Scene::kMagnitude;
  }
  if (!ParseInteger(text, component) || component < 0)
  {
    Refuse("--component", text, "'magnitude' or a number from 0");
  }
  return component;
}
} // namespace

void ShotOptions::AddTo(CLI::App& command, bool required)
{
  input.AddTo(command, required);
  AddText(command, "--field", field, "NAME", "Name of the field").Required(required);
  AddRead(
    command, "--component", [this](const std::string& text) { component = ParseComponent(text); },
    "magnitude|i", "Component of a vector field, counted from 0, or its magnitude (default)");
  AddSize(command, "--size", size, "Size of the image in pixels (default: 1000x1000)");
  AddChoice(
    command, "--precision",
    [this](const std::string& text)
    { precision = text == "float" ? Precision::Float : Precision::Double; },
    { "double", "float" },
    "What values are computed in (default: double); what float costs is told");
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
