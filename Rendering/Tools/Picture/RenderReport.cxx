// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/RenderReport.h"

#include "Base/Report.h"
#include "Picture/ContourReport.h"
#include "Picture/Figure.h"
#include "Scene/DebugOptions.h"
#include "Scene/Shot.h"
#include "Scene/ShotAppearance.h"

#include "Core/Base/Counted.h"
#include "Core/Location/Locator.h"
#include "Trace/Surfaces/JumpWalls.h"
#include "Trace/TraceTile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <string>

namespace pixelexact
{
namespace
{
nlohmann::ordered_json ToJson(const CameraView& view)
{
  const auto numbers = [](const Vec3& v) { return std::array{ v.x, v.y, v.z }; };
  nlohmann::ordered_json camera{ { "position", numbers(view.position) },
    { "focal_point", numbers(view.focalPoint) }, { "view_up", numbers(view.viewUp) } };
  if (view.parallel)
  {
    camera["parallel_scale"] = view.parallelScale;
  }
  else
  {
    camera["view_angle"] = view.viewAngle;
  }
  return camera;
}

/// Null where nothing is coloured by value.
nlohmann::ordered_json RangeToJson(const ShotAppearance& appearance, std::size_t layer)
{
  const auto& range = appearance.Ranges()[layer];
  return range ? nlohmann::ordered_json(*range) : nlohmann::ordered_json();
}

/// Null where there is no field.
nlohmann::ordered_json FieldToJson(const Layer& layer)
{
  return layer.field != nullptr ? nlohmann::ordered_json(layer.field->name)
                                : nlohmann::ordered_json();
}

nlohmann::ordered_json ComponentToJson(const Layer& layer)
{
  return layer.field != nullptr ? nlohmann::ordered_json(ComponentName(layer))
                                : nlohmann::ordered_json();
}

nlohmann::ordered_json LayersToJson(
  const Shot& shot, const Frame& frame, const ShotAppearance& appearance)
{
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const Layer& layer = shot.scene.layers[k];
    layers.push_back({ { "field", FieldToJson(layer) }, { "component", ComponentToJson(layer) },
      { "opacity", shot.settings[k].opacity }, { "color_range", RangeToJson(appearance, k) },
      { "pixels", std::ranges::count(frame.centres.layer, k) } });
  }
  return layers;
}

/// Layers that are walls of iso-surfaces.
struct FoundWalls
{
  int layers = 0;
  std::int64_t faces = 0; ///< on which there may be some
  std::int64_t pixels = 0;
};

FoundWalls WallsOf(const Shot& shot, const Frame& frame)
{
  FoundWalls found;
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    if (const auto* walls = dynamic_cast<const JumpWalls*>(shot.scene.layers[k].surface.get()))
    {
      ++found.layers;
      found.faces += walls->Parts();
      found.pixels += std::ranges::count(frame.centres.layer, k);
    }
  }
  return found;
}

/// A layer's field and component.
std::string Described(const Layer& layer)
{
  return layer.field->name + FieldKind(*layer.field) +
    (layer.field->values.components > 1 ? ", " + ComponentName(layer) : std::string());
}

void AddRanges(Table& table, const ShotAppearance& appearance, const Found& found)
{
  std::string name = "range";
  const auto& ranges = appearance.Ranges();
  for (std::size_t k = 0; k < ranges.size(); ++k)
  {
    if (ranges[k])
    {
      table.Row(name, "{} to {}{}", Short((*ranges[k])[0]), Short((*ranges[k])[1]),
        ranges.size() > 1 ? fmt::format("; layer {}", k + 1) : std::string());
      name.clear();
    }
  }
  if (found.beyond.below + found.beyond.above > 0)
  {
    table.Row("", "{} below, {} above", Counted(found.beyond.below, "pixel"), found.beyond.above);
  }
}
} // namespace

void PrintJson(const Shot& shot, const Frame& frame, const Found& found,
  const ShotAppearance& appearance, const DebugOptions& debug, const RepeatedCommand& command,
  const Stopwatch& stopwatch)
{
  const Layer& first = shot.scene.layers.front();
  const FrameCounters& pixels = frame.counters;
  nlohmann::ordered_json summary{ { "elements", shot.input.elements },
    { "field", FieldToJson(first) }, { "component", ComponentToJson(first) } };
  AddTime(summary, shot.input);
  summary.update({ { "width", frame.width }, { "height", frame.height },
    { "pixels",
      { { "exact", pixels.exact }, { "nothing", pixels.nothing }, { "unknown", pixels.unknown } } },
    { "non_finite", pixels.nonFinite },
    { "value_range",
      found.values ? nlohmann::ordered_json(*found.values) : nlohmann::ordered_json() },
    { "color_range", debug.IsInPlace() ? nlohmann::ordered_json() : RangeToJson(appearance, 0) },
    { "beyond_range", { { "below", found.beyond.below }, { "above", found.beyond.above } } },
    { "camera", ToJson(shot.view) } });
  if (found.arrows)
  {
    summary["arrows"] = { { "field", found.arrows->field },
      { "count", found.arrows->arrows.size() }, { "longest", found.arrows->longest },
      { "scale", found.arrows->scale } };
  }
  if (found.dots)
  {
    summary["dots"] = { { "field", found.dots->field }, { "points", found.dots->points },
      { "visible", found.dots->dots.size() } };
  }
  if (found.texture)
  {
    summary["lic"] = { { "field", found.texture->field }, { "pixels", found.texture->pixels },
      { "samples", found.texture->samples } };
  }
  if (shot.layout)
  {
    summary["figure"] = ToJson(*shot.layout);
  }
  if (found.beyond.noLogarithm > 0)
  {
    summary["no_logarithm"] = { { "pixels", found.beyond.noLogarithm },
      { "values", found.beyond.noLogarithmRange } };
  }
  if (shot.scene.layers.size() > 1)
  {
    summary["layers"] = LayersToJson(shot, frame, appearance);
  }
  if (pixels.numericHits + pixels.undecidedHits + pixels.cutOff > 0)
  {
    summary["hits"] = { { "numeric", pixels.numericHits }, { "undecided", pixels.undecidedHits },
      { "cut_off", pixels.cutOff } };
  }
  if (const FoundWalls walls = WallsOf(shot, frame); walls.layers > 0)
  {
    summary["jump_walls"] = { { "faces", walls.faces }, { "pixels", walls.pixels } };
  }
  if (found.volume)
  {
    summary["volume"] = { { "field", shot.volume->field->name },
      { "opacity_unit", shot.volume->transfer->Unit() }, { "proven", found.volume->proven },
      { "unproven", found.volume->unproven }, { "largest_bound", found.volume->largest } };
  }
  if (found.contours)
  {
    summary["contours"] = ToJson(*found.contours);
  }
  if (shot.appearance.samples > 1)
  {
    summary["refined_pixels"] = appearance.GetPainter().Refined();
  }
  if (pixels.floatCheck.points > 0)
  {
    summary["float"] = { { "checked", pixels.floatCheck.points },
      { "largest_difference", pixels.floatCheck.largest } };
  }
  debug.AddTo(summary);
  found.quality.AddTo(summary);
  const LocationCounters& location = shot.scene.locator->Counters();
  summary["location"] = { { "queries", location.queries.load() },
    { "candidates", location.candidates.load() }, { "careful", location.careful.load() },
    { "unknown", location.unknown.load() } };
  summary["command"] = command.Words();
  summary["seconds"] = ToJson(stopwatch);
  Print(summary);
}

void PrintTable(const Shot& shot, const Frame& frame, const Found& found,
  const ShotAppearance& appearance, const DebugOptions& debug, const RepeatedCommand& command,
  const Stopwatch& stopwatch, bool onStderr)
{
  Table table;
  table.Row("elements", "{}", shot.input.elements);
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const Layer& layer = shot.scene.layers[k];
    const std::string pixels = shot.scene.layers.size() > 1
      ? fmt::format(
          "; layer {}, {}", k + 1, Counted(std::ranges::count(frame.centres.layer, k), "pixel"))
      : std::string();
    table.Row(k == 0 ? "field" : "", (layer.field != nullptr ? Described(layer) : "none") + pixels);
  }
  AddTime(table, shot.input);
  table.Row("size", "{} x {}", frame.width, frame.height);
  const FrameCounters& pixels = frame.counters;
  table.Row(
    "pixels", "{} exact, {} nothing, {} unknown", pixels.exact, pixels.nothing, pixels.unknown);
  table.Row("non-finite", "{}", pixels.nonFinite);
  table.Row("values",
    found.values ? Short((*found.values)[0]) + " to " + Short((*found.values)[1]) : "none");
  if (!debug.IsInPlace())
  {
    AddRanges(table, appearance, found);
  }
  if (pixels.numericHits + pixels.undecidedHits + pixels.cutOff > 0)
  {
    table.Row("hits", "{} numeric, {} undecided, {} cut off", pixels.numericHits,
      pixels.undecidedHits, Counted(pixels.cutOff, "ray"));
  }
  if (const FoundWalls walls = WallsOf(shot, frame); walls.layers > 0)
  {
    table.Row("jump walls",
      walls.faces > 0
        ? fmt::format("{} of {}", Counted(walls.pixels, "pixel"), Counted(walls.faces, "face"))
        : "none: nowhere does the field jump across the value");
  }
  if (found.volume)
  {
    table.Row("volume", "{}: {} proven within {} of a byte's level, {} not proven",
      shot.volume->field->name, Counted(found.volume->proven, "pixel"),
      Short(found.volume->largest), found.volume->unproven);
  }
  if (found.contours)
  {
    AddContours(table, *found.contours);
  }
  if (shot.appearance.samples > 1)
  {
    table.Row("smoothed", Counted(appearance.GetPainter().Refined(), "pixel"));
  }
  if (pixels.floatCheck.points > 0)
  {
    table.Row("float", "at most {} from double at {} evaluated in both",
      Short(pixels.floatCheck.largest), Counted(pixels.floatCheck.points, "point"));
  }
  debug.AddTo(table);
  found.quality.AddTo(table);
  AddStages(table, stopwatch);
  if (!command.chosen.empty())
  {
    table.Row("repeat", command.Text());
  }
  table.Print(onStderr);
}

void WarnOf(const Shot& shot, const Frame& frame, const Found& found)
{
  const PixelsBeyond& beyond = found.beyond;
  if (found.volume && found.volume->unproven > 0)
  {
    Warn(Counted(found.volume->unproven, "pixel") + " of the volume " +
      (found.volume->unproven == 1 ? "is" : "are") +
      " not proven: their colours are sampled or have larger bounds (buffer VolumeBound)");
  }
  if (found.volume && shot.volume->transfer->IsLimited())
  {
    Note("opacities above " + Short(TransferFunction::kMaxOpacity) +
      " per unit distance are lowered to it; an opacity of 1 would have no thickness");
  }
  if (frame.counters.exact == 0 && frame.counters.unknown == 0 && !found.volume)
  {
    Warn("no pixel meets the mesh on a surface; the picture shows none of it");
  }
  if (frame.counters.unknown > 0)
  {
    Warn(Counted(frame.counters.unknown, "pixel") + " could not be decided; shown as unknown");
  }
  if (frame.counters.nonFinite > 0)
  {
    Warn("NaN or infinite at " + Counted(frame.counters.nonFinite, "pixel") +
      "; NaN is shown in the colour that --nan-color chooses");
    if (HasJumps(shot.scene))
    {
      Warn("jump(...) has values only on faces between two elements (--faces or "
           "--boundary=element:NUMBER,... "
           "shows faces); --show jumps paints by how much a field jumps where a surface crosses "
           "faces");
    }
  }
  if (beyond.noLogarithm > 0)
  {
    const auto& [lowest, highest] = beyond.noLogarithmRange;
    Warn("--log: no logarithm at " + Counted(beyond.noLogarithm, "pixel") + ", of values from " +
      Short(lowest) + " to " + Short(highest) +
      "; shown in the colour of NaN; leave out --log, or choose the colour with --nan-color");
  }
  if (found.contours && CountOf(*found.contours) > 0 &&
    found.contours->outside == CountOf(*found.contours) && found.contours->pixels.in == 0)
  {
    Warn("--contours: all of the values lie outside of those that the picture shows" +
      (found.values ? ", " + Short((*found.values)[0]) + " to " + Short((*found.values)[1])
                    : std::string()) +
      "; there are no lines");
  }
  if (found.contours && found.contours->ofOneValue)
  {
    Warn("--contours: a surface shows one value, up to rounding" +
      (found.values ? ", " + Short((*found.values)[0]) : std::string()) +
      "; there are no others to draw lines of; give the values that are meant");
  }
  if (frame.counters.cutOff > 0)
  {
    Warn("more than " + std::to_string(Sheets::kMax) + " translucent surfaces on " +
      Counted(frame.counters.cutOff, "ray") + "; what is behind is not shown");
  }
}
} // namespace pixelexact
