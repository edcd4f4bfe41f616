// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Shot.h"

#include "Base/Command.h"
#include "Base/Processes.h"
#include "Base/Report.h"
#include "Scene/Effects.h"
#include "Scene/NeededElements.h"

#include "Conversion/ConvertedGrid.h"
#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/NoSurface.h"
#include "Trace/View.h"

#include "Views/FittedView.h"
#include "Views/VtkLook.h"

#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace pixelexact
{
void ShotOptions::AddTo(CLI::App& added)
{
  command = &added;
  input.AddTo(added);
  Bind(added, "--field", field);
  Bind(added, "--component",
    [this](const std::string& text)
    {
      component = ParseComponent(text);
      if (!component)
      {
        Refuse("--component", text, "'magnitude', x, y, z or a number from 0");
      }
    });
  Bind(added, "--size", size);
  Bind(added, "--precision",
    [this](const std::string& text)
    { precision = text == "float" ? Precision::Float : Precision::Double; });
  surfaces.AddTo(added);
  layers.AddTo(added);
  camera.AddTo(added);
  colors.AddTo(added);
  Bind(added, "--lights",
    [this](const std::string& text)
    { lights = text == "curved" ? Lit::Curved : (text == "on" ? Lit::On : Lit::Off); });
  Bind(added, "--samples", samples);
  Bind(added, "--edges", edgeWidth);
  Bind(added, "--edge-color", edgeColor);
  Bind(added, "--edges-by-kind", edgesByKind);
  Bind(added, "--outlines", outlines);
  Bind(added, "--outline-color", outlineColor);
}

namespace
{
/// The only field of all layers and surfaces; empty: there are several, or it depends on
/// the input.
std::string FieldToLoad(const ShotOptions& options, const std::vector<LayerSettings>& layers)
{
  if (options.volume.IsAsked() && options.volume.Name() != options.field)
  {
    return options.HasVolumeAlone() ? options.volume.Name() : std::string();
  }
  for (const LayerSettings& layer : layers)
  {
    if (layer.field && *layer.field != options.field)
    {
      return {};
    }
  }
  const auto isSame = [&options](const std::string& name) { return name == options.field; };
  return std::ranges::all_of(options.surfaces.Fields(), isSame) &&
      std::ranges::all_of(options.otherFields, isSame)
    ? options.field
    : std::string();
}

Layer MakeLayer(const ShotOptions& options, const LayerSettings& settings,
  const std::shared_ptr<const Surface>& surface, const Field& field)
{
  Layer layer{ surface, &field };
  const int components = layer.field->values.components;
  // A component for all layers does not apply to a layer with its own field.
  const std::optional<int> asked =
    settings.component ? settings.component : (settings.field ? std::nullopt : options.component);
  layer.component = asked.value_or(components == 1 ? 0 : kMagnitude);
  if (layer.component >= components)
  {
    throw Error((settings.component ? "--layer" : "--component") + std::string(": field '") +
      field.name + "' has " + std::to_string(components) +
      (components == 1 ? " component" : " components") + ", counted from 0");
  }
  layer.precision = settings.precision.value_or(options.precision);
  if (layer.precision == Precision::Float && field.function != nullptr)
  {
    throw UsageError((settings.precision ? "--layer: precision=float" : "--precision float") +
      std::string(": values of the expression '") + field.name +
      "' are computed in double precision; leave it out");
  }
  return layer;
}

void AddLayers(const ShotOptions& options,
  const std::vector<std::shared_ptr<const Surface>>& surfaces, Shot& shot)
{
  const HighOrderModel& model = *shot.input.model;
  if (options.HasVolumeAlone())
  {
    shot.scene.layers.push_back({ std::make_shared<NoSurface>() });
    return;
  }
  if (model.Fields().empty())
  {
    CheckEffectsWithoutField(*options.command, shot.settings);
    for (std::size_t k = 0; k < surfaces.size(); ++k)
    {
      shot.scene.layers.push_back({ surfaces[k] });
    }
    return;
  }
  const bool shared = std::ranges::any_of(
    shot.settings, [](const LayerSettings& settings) { return !settings.field; });
  const Field* ofAll = shared ? &FieldOrFirst(model, options.field) : nullptr;
  for (std::size_t k = 0; k < surfaces.size(); ++k)
  {
    const LayerSettings& settings = shot.settings[k];
    shot.scene.layers.push_back(MakeLayer(
      options, settings, surfaces[k], settings.field ? model.GetField(*settings.field) : *ofAll));
  }
}

/// Reports defaults, so that the picture can be reproduced.
void ReportDefaults(const ShotOptions& options, Shot& shot)
{
  if (options.HasVolumeAlone())
  {
    return;
  }
  const bool shared = std::ranges::any_of(
    shot.settings, [](const LayerSettings& settings) { return !settings.field; });
  if (options.field.empty() && shared && !shot.input.model->Fields().empty())
  {
    shot.chosen.insert(shot.chosen.end(), { "--field", shot.input.model->Fields().front().name });
  }
  if (!options.surfaces.AreGiven() && options.meshChanges && SlabOf(shot.input.grid))
  {
    Note("no surface was given; each picture shows its own mesh");
  }
  else if (!options.surfaces.AreGiven() && shot.input.model->IsShell())
  {
    shot.chosen.emplace_back("--boundary");
  }
  else if (!options.surfaces.AreGiven())
  {
    const std::string plane = PlaneChoice::ThroughTheMiddle().Numbers(BoxOf(*shot.input.model));
    shot.chosen.push_back("--plane=" + plane);
    Note("no surface was given; cut by --plane " + plane);
  }
}
} // namespace

std::vector<Vec3> SeenPoints(const Scene& scene, const CameraView& view, const ImageSize& size)
{
  const auto [width, height] = SmallSize(size.width, size.height);
  return SeenPoints(scene, { view, width, height });
}

namespace
{
/// Colour of the walls of iso-surfaces, which occurs in no default colour map.
constexpr std::array<double, 3> kWallColor{ 0.84, 0.37, 0.0 };
} // namespace

bool ShotOptions::HasVolumeAlone() const
{
  return volume.IsAsked() && !surfaces.AreGiven();
}

bool ShotOptions::SpansAllPictures() const
{
  const std::vector<LayerSettings> all = layers.Make(surfaces.Count());
  return colors.Range().of == RangeRule::Of::All ||
    std::ranges::any_of(all,
      [](const LayerSettings& layer)
      { return layer.range && layer.range->of == RangeRule::Of::All; });
}

void ShotOptions::CheckRangeOfOne() const
{
  if (SpansAllPictures())
  {
    throw UsageError(
      std::string(colors.Range().of == RangeRule::Of::All ? "--range" : "--layer: range") +
      " 'all': there is one picture; choose cut, or give --sweep, --turn or --time-step all");
  }
}

std::vector<LayerSettings> ShotOptions::MakeLayers() const
{
  std::vector<LayerSettings> settings = layers.Make(surfaces.Count());
  CheckEffects(*command, settings);
  for (std::size_t k = settings.size() - surfaces.CountWalls(); k < settings.size(); ++k)
  {
    LayerSettings& wall = settings[k];
    const bool hasColors = wall.color || wall.colormap || wall.range || wall.field;
    wall.color = hasColors ? wall.color : kWallColor;
  }
  for (const LayerSettings& layer : settings)
  {
    if (colors.Logarithm() && layer.range)
    {
      CheckLogarithm("--layer: range", *layer.range);
    }
  }
  return settings;
}

namespace
{
/// Half-spaces as vtkMapper::GetClippingPlaneInDataCoords returns them.
std::vector<KeptHalfSpace> HalfSpacesOf(const std::vector<std::vector<double>>& planes)
{
  std::vector<KeptHalfSpace> kept;
  for (const std::vector<double>& p : planes)
  {
    if (p[3] == 0.0 && p[4] == 0.0 && p[5] == 0.0)
    {
      throw UsageError("--clip: the normal is zero; give one that points to what stays");
    }
    kept.push_back({ p[3], p[4], p[5], -(p[3] * p[0] + p[4] * p[1] + p[5] * p[2]) });
  }
  return kept;
}

/// Samples, edges and outlines, but not the faces of edges by kind.
Appearance SharedAppearance(const ShotOptions& options)
{
  Appearance appearance;
  appearance.samples = options.samples;
  if (options.edgeWidth)
  {
    appearance.edges = options.edgesByKind
      ? EdgeStyle::ByKind(options.edgeWidth->Pixels())
      : EdgeStyle::Plain(options.edgeWidth->Pixels(), ToRgba(options.edgeColor.data()));
  }
  if (options.outlines)
  {
    appearance.outlines = ToRgba(options.outlineColor.data());
  }
  return appearance;
}

/// The input of one process, of which `before` may have read the time step.
LoadedModel LoadWhole(
  const ShotOptions& options, const std::string& field, Stopwatch& stopwatch, const Shot* before)
{
  if (before != nullptr && before->input.step == options.input.step)
  {
    return Changed(before->input, options.input);
  }
  return LoadModel(
    options.input, field, stopwatch, before != nullptr ? before->input.source.Get() : nullptr);
}

/// All but the view. `loaded`: the input, where it was read; null: it is read.
Shot MakeShot(
  const ShotOptions& options, Stopwatch& stopwatch, const Shot* before, LoadedModel* loaded)
{
  Shot shot;
  shot.size = options.size;
  shot.lights = options.lights;
  shot.appearance = SharedAppearance(options);
  shot.settings = options.MakeLayers();
  const std::vector<GivenSurface> given = options.surfaces.Make();
  const std::string field = FieldToLoad(options, shot.settings);
  if (loaded != nullptr)
  {
    shot.input = std::move(*loaded);
  }
  else if (AreSeveralProcesses())
  {
    if (options.surfaces.CountWalls() > 0 || options.surfaces.HasInnerFaces())
    {
      throw UsageError(std::string(options.surfaces.HasInnerFaces() ? "--faces" : "--jump-walls") +
        ": what lies on both sides of a face is known to one process "
        "that has the whole mesh; start one, without mpirun");
    }
    shot.input = LoadPart(options.input, field, stopwatch);
    shot.input = WithNeededElements(std::move(shot.input), options.surfaces);
    stopwatch.Stage("exchange");
  }
  else
  {
    shot.input = LoadWhole(options, field, stopwatch, before);
  }
  if (before == nullptr && loaded == nullptr)
  {
    WarnOfDiagnostics(shot.input);
  }
  const HighOrderModel& model = *shot.input.model;
  std::vector<std::shared_ptr<const Surface>> surfaces;
  surfaces.reserve(given.size());
  for (const GivenSurface& surface : given)
  {
    surfaces.push_back(surface(shot.input.model));
  }
  AddLayers(options, surfaces, shot);
  if (options.volume.IsAsked())
  {
    shot.volume = options.volume.Make(model, options.colors, options.HasVolumeAlone());
  }
  shot.truncated = TruncatedFields(shot);
  if (before == nullptr)
  {
    ReportDefaults(options, shot);
  }
  shot.scene.locator = &model.GetLocator();
  shot.scene.kept = HalfSpacesOf(options.clip);
  shot.appearance.faces = options.edgeWidth && options.edgesByKind ? &model.Faces() : nullptr;
  stopwatch.Stage("bounds+bvh");
  return shot;
}

/// Throws UsageError for a width alone, whose height a figure's layout determines.
void CheckHeight(const ShotOptions& options)
{
  if (options.size.height == 0 && !options.layout)
  {
    throw UsageError("--size: a width alone is that of a --figure; give WIDTHxHEIGHT");
  }
}

Shot PrepareWithView(const ShotOptions& options, Stopwatch& stopwatch, LoadedModel* loaded)
{
  CheckHeight(options);
  options.camera.Check();
  options.colors.Check();
  Shot shot = MakeShot(options, stopwatch, nullptr, loaded);
  const Box3 box = BoxOf(*shot.input.model);
  const auto& first = shot.scene.layers.front().surface;
  // A surface that is not flat has normals in many directions. A mesh that is a surface may lie in
  // a plane, which is seen from its edge only by chance.
  const Vec3 oblique = shot.input.model->IsShell() ? Vec3(1.0, 0.7, 0.55) : Vec3(1.0);
  const Vec3 towards =
    first->IsFlat() ? SideOfPlane(first->Normal({ 0.5 * (box.lower + box.upper) })) : oblique;
  if (options.layout)
  {
    shot.view = options.camera.Make(box, towards, { 1, 1, {} });
    shot.layout = options.layout(shot);
    shot.size = shot.layout->picture;
  }
  shot.view = options.camera.Make(box, towards, shot.size);
  if (!options.camera.IsPlaced())
  {
    shot.view = FitView(shot.view, shot.size.width, shot.size.height, options.camera.HasScale(),
      [&](const CameraView& view)
      {
        shot.view = view;
        std::vector<Vec3> points = SeenPoints(shot.scene, view, shot.size);
        if (shot.volume)
        {
          std::ranges::copy(CornersOfBox(shot), std::back_inserter(points));
        }
        if (options.alsoSeen)
        {
          std::ranges::copy(options.alsoSeen(shot), std::back_inserter(points));
        }
        return points;
      });
  }
  stopwatch.Stage("camera");
  return shot;
}
} // namespace

std::array<Vec3, 8> CornersOfBox(const Shot& shot)
{
  const Box3 box = BoxOf(*shot.input.model);
  std::array<Vec3, 8> corners{};
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    corners[k] = { (k & 1U) != 0 ? box.upper.x : box.lower.x,
      (k & 2U) != 0 ? box.upper.y : box.lower.y, (k & 4U) != 0 ? box.upper.z : box.lower.z };
  }
  return corners;
}

Shot Prepare(const ShotOptions& options, Stopwatch& stopwatch)
{
  return PrepareWithView(options, stopwatch, nullptr);
}

Shot Prepare(const ShotOptions& options, LoadedModel input, Stopwatch& stopwatch)
{
  return PrepareWithView(options, stopwatch, &input);
}

Shot PrepareStep(const ShotOptions& options, int step, const Shot& before, Stopwatch& stopwatch)
{
  ShotOptions asked = options;
  asked.input.step = step;
  asked.input.allSteps = false;
  if (const Field* field = before.scene.layers.front().field; asked.field.empty() && field)
  {
    asked.field = field->name;
  }
  Shot shot = MakeShot(asked, stopwatch, &before, nullptr);
  shot.view = before.view;
  shot.size = before.size;
  shot.layout = before.layout;
  shot.chosen = before.chosen;
  return shot;
}

std::string ComponentName(const Layer& layer)
{
  if (layer.component == kMagnitude)
  {
    return "magnitude";
  }
  return layer.field->values.components == 1 ? "value" : std::to_string(layer.component);
}
} // namespace pixelexact
