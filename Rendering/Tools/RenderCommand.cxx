// SPDX-License-Identifier: BSD-3-Clause
#include "BufferOptions.h"
#include "Command.h"
#include "DebugOptions.h"
#include "Looks.h"
#include "Output.h"
#include "Picture.h"
#include "Report.h"
#include "Shot.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Trace/Sheets.h"
#include "Trace/Tracer.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

namespace pixelexact
{
namespace
{
struct RenderOptions
{
  ShotOptions shot;
  DebugOptions debug;
  BufferOptions buffers;
  std::string output;
  std::string contours;
};

/// What there is to tell of the values.
struct Found
{
  std::optional<std::array<double, 2>> values; ///< of exact pixels
  PixelsBeyond beyond;                         ///< ranges of colour maps
};

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
nlohmann::ordered_json RangeToJson(const Looks& looks, std::size_t layer)
{
  const auto& range = looks.Ranges()[layer];
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

nlohmann::ordered_json LayersToJson(const Shot& shot, const Frame& frame, const Looks& looks)
{
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const Layer& layer = shot.scene.layers[k];
    layers.push_back({ { "field", FieldToJson(layer) }, { "component", ComponentToJson(layer) },
      { "opacity", shot.settings[k].opacity }, { "color_range", RangeToJson(looks, k) },
      { "pixels", std::ranges::count(frame.centres.layer, k) } });
  }
  return layers;
}

void PrintJson(const Shot& shot, const Frame& frame, const Found& found, const Looks& looks,
  const DebugOptions& debug, const Stopwatch& stopwatch)
{
  const Layer& first = shot.scene.layers.front();
  const FrameCounters& pixels = frame.counters;
  nlohmann::ordered_json summary{ { "elements", shot.input.model->GetMesh().Elements() },
    { "field", FieldToJson(first) }, { "component", ComponentToJson(first) } };
  AddTime(summary, shot.input);
  summary.update({ { "width", frame.width }, { "height", frame.height },
    { "pixels",
      { { "exact", pixels.exact }, { "nothing", pixels.nothing }, { "unknown", pixels.unknown } } },
    { "non_finite", pixels.nonFinite },
    { "value_range",
      found.values ? nlohmann::ordered_json(*found.values) : nlohmann::ordered_json() },
    { "color_range", RangeToJson(looks, 0) },
    { "beyond_range", { { "below", found.beyond.below }, { "above", found.beyond.above } } },
    { "camera", ToJson(shot.view) } });
  if (found.beyond.noLogarithm > 0)
  {
    summary["no_logarithm"] = { { "pixels", found.beyond.noLogarithm },
      { "values", found.beyond.noLogarithmRange } };
  }
  if (shot.scene.layers.size() > 1)
  {
    summary["layers"] = LayersToJson(shot, frame, looks);
  }
  if (pixels.numericHits + pixels.undecidedHits + pixels.cutOff > 0)
  {
    summary["hits"] = { { "numeric", pixels.numericHits }, { "undecided", pixels.undecidedHits },
      { "cut_off", pixels.cutOff } };
  }
  if (shot.samples > 1)
  {
    summary["refined_pixels"] = looks.Refined();
  }
  if (pixels.floatCheck.points > 0)
  {
    summary["float"] = { { "checked", pixels.floatCheck.points },
      { "largest_difference", pixels.floatCheck.largest } };
  }
  debug.AddTo(summary);
  const LocationCounters& location = shot.scene.locator->Counters();
  summary["location"] = { { "queries", location.queries.load() },
    { "candidates", location.candidates.load() }, { "careful", location.careful.load() },
    { "unknown", location.unknown.load() } };
  summary["seconds"] = ToJson(stopwatch);
  Print(summary);
}

/// A layer's field and component.
std::string Described(const Layer& layer)
{
  return layer.field->name + FieldKind(*layer.field) +
    (layer.field->values.components > 1 ? ", " + ComponentName(layer) : std::string());
}

void AddRanges(Table& table, const Looks& looks, const Found& found)
{
  std::string name = "range";
  const auto& ranges = looks.Ranges();
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

void PrintTable(const Shot& shot, const Frame& frame, const Found& found, const Looks& looks,
  const DebugOptions& debug, const Stopwatch& stopwatch, bool onStderr)
{
  Table table;
  table.Row("elements", "{}", shot.input.model->GetMesh().Elements());
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
  AddRanges(table, looks, found);
  if (pixels.numericHits + pixels.undecidedHits + pixels.cutOff > 0)
  {
    table.Row("hits", "{} numeric, {} undecided, {} cut off", pixels.numericHits,
      pixels.undecidedHits, Counted(pixels.cutOff, "ray"));
  }
  if (shot.samples > 1)
  {
    table.Row("smoothed", Counted(looks.Refined(), "pixel"));
  }
  if (pixels.floatCheck.points > 0)
  {
    table.Row("float", "at most {} from double at {} evaluated in both",
      Short(pixels.floatCheck.largest), Counted(pixels.floatCheck.points, "point"));
  }
  debug.AddTo(table);
  AddStages(table, stopwatch);
  table.Print(onStderr);
}

void WarnOf(const Frame& frame, const PixelsBeyond& beyond)
{
  if (frame.counters.exact == 0 && frame.counters.unknown == 0)
  {
    Warn("no pixel meets the mesh on a surface; the picture shows the background alone");
  }
  if (frame.counters.unknown > 0)
  {
    Warn(Counted(frame.counters.unknown, "pixel") + " could not be decided; shown as unknown");
  }
  if (frame.counters.nonFinite > 0)
  {
    Warn("NaN or infinite at " + Counted(frame.counters.nonFinite, "pixel") +
      "; NaN is shown in the colour that --nan-color chooses");
  }
  if (beyond.noLogarithm > 0)
  {
    const auto& [lowest, highest] = beyond.noLogarithmRange;
    Warn("--log: no logarithm at " + Counted(beyond.noLogarithm, "pixel") + ", of values from " +
      Short(lowest) + " to " + Short(highest) +
      "; shown in the colour of NaN; leave out --log, or choose the colour with --nan-color");
  }
  if (frame.counters.cutOff > 0)
  {
    Warn("more than " + std::to_string(Sheets::kMost) + " translucent surfaces on " +
      Counted(frame.counters.cutOff, "ray") + "; what is behind is not shown");
  }
}

/// A file of another kind than its name says would mislead whoever opens it.
void CheckSuffix(const char* option, const std::string& file, const char* suffix)
{
  if (!file.empty() && !IsStandardStream(file) && std::filesystem::path(file).extension() != suffix)
  {
    throw UsageError(
      std::string(option) + ": '" + file + "' is written as " + suffix + "; name it so");
  }
}

void Render(const RenderOptions& options, const CommonOptions& common)
{
  if (!options.contours.empty())
  {
    throw Unsupported("--contours is not available yet; leave it out");
  }
  CheckSuffix("--output", options.output, ".png");
  CheckSuffix("--buffers", options.buffers.File(), ".vti");
  const std::vector<std::string> outputs{ options.output, options.buffers.File() };
  CheckStandardOutput(outputs, common.json);
  CheckOutput("--output", options.output, options.shot.input.files);
  CheckOutput("--buffers", options.buffers.File(), options.shot.input.files);
  options.buffers.Check();
  DebugOptions debug = options.debug;
  debug.Check(options.shot.samples, options.shot.MakeLayers());
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.shot, stopwatch);

  const bool hasField = shot.scene.layers.front().field != nullptr;
  const Buffer wanted = NeedsOfLooks(shot) | debug.Needs() | options.buffers.Needs(hasField);
  Frame frame = [&]
  {
    ProgressLine line("tracing");
    return Trace(shot.scene, shot.MakeCamera(), {}, { .centres = wanted }, std::ref(line));
  }();
  // Colours afterwards, because the default range is that of the values found.
  Looks looks(options.shot.colors, shot, frame);
  Pipeline pipeline = looks.MakePipeline();
  debug.AddTo(pipeline, shot, looks, frame);
  Repaint(shot.scene, shot.MakeCamera(), pipeline, frame);
  debug.Count(frame);
  Found found;
  found.values = ValueRange(frame, -std::numeric_limits<double>::infinity());
  if (!debug.IsInPlace())
  {
    found.beyond = CountBeyond(frame, looks.Ranges(), options.shot.colors.Logarithm());
  }
  stopwatch.Stage("trace+colour");

  WritePng(options.output, frame.width, frame.height, options.shot.colors.Flatten(frame));
  if (!options.buffers.File().empty())
  {
    WriteBuffers(
      options.buffers.File(), options.buffers.Arrays(), frame, shot.input.model->SourceCells());
  }
  stopwatch.Stage("write");

  WarnOf(frame, found.beyond);
  if (common.json)
  {
    PrintJson(shot, frame, found, looks, debug, stopwatch);
  }
  else
  {
    PrintTable(
      shot, frame, found, looks, debug, stopwatch, std::ranges::any_of(outputs, IsStandardStream));
  }
}
} // namespace

void AddRenderCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<RenderOptions>();
  CLI::App& command =
    AddCommand(program, "render", "Cut a field by surfaces and colour every pixel exactly",
      [options, &common, &action] { action = [options, &common] { Render(*options, common); }; });
  options->shot.AddTo(command);
  options->debug.AddTo(command);
  AddText(command, "-o,--output", options->output, "IMAGE.png",
    "PNG image to write; - for standard output")
    .Required();
  options->buffers.AddTo(command);
  AddText(
    command, "--contours", options->contours, "N|v1,v2,...", "Contour lines (not available yet)");
}
} // namespace pixelexact
