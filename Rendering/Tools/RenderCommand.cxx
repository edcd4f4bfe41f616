// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "DebugOptions.h"
#include "Looks.h"
#include "Picture.h"
#include "Report.h"
#include "Shot.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"
#include "Trace/BufferTable.h"
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
  std::string output;
  std::string buffers;
  std::string contours;
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

nlohmann::ordered_json LayersToJson(const Shot& shot, const Frame& frame, const Looks& looks)
{
  nlohmann::ordered_json layers = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const Layer& layer = shot.scene.layers[k];
    layers.push_back({ { "field", layer.field->name }, { "component", ComponentName(layer) },
      { "opacity", shot.settings[k].opacity }, { "color_range", looks.Ranges()[k] },
      { "pixels", std::ranges::count(frame.centres.layer, k) } });
  }
  return layers;
}

void PrintJson(const Shot& shot, const Frame& frame,
  const std::optional<std::array<double, 2>>& values, const Looks& looks, const DebugOptions& debug,
  const Stopwatch& stopwatch)
{
  const Layer& first = shot.scene.layers.front();
  const FrameCounters& pixels = frame.counters;
  nlohmann::ordered_json summary{ { "elements", shot.input.model->GetMesh().Elements() },
    { "field", first.field->name }, { "component", ComponentName(first) } };
  AddTime(summary, shot.input);
  summary.update({ { "width", frame.width }, { "height", frame.height },
    { "pixels",
      { { "exact", pixels.exact }, { "nothing", pixels.nothing }, { "unknown", pixels.unknown } } },
    { "non_finite", pixels.nonFinite },
    { "value_range", values ? nlohmann::ordered_json(*values) : nlohmann::ordered_json() },
    { "color_range", looks.Ranges().front() }, { "camera", ToJson(shot.view) } });
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

void PrintTable(const Shot& shot, const Frame& frame,
  const std::optional<std::array<double, 2>>& values, const Looks& looks, const DebugOptions& debug,
  const Stopwatch& stopwatch)
{
  Table table;
  table.Row("elements", "{}", shot.input.model->GetMesh().Elements());
  for (std::size_t k = 0; k < shot.scene.layers.size(); ++k)
  {
    const Layer& layer = shot.scene.layers[k];
    const std::string pixels = shot.scene.layers.size() > 1
      ? fmt::format("; layer {}, {} pixels", k + 1, std::ranges::count(frame.centres.layer, k))
      : std::string();
    table.Row(k == 0 ? "field" : "",
      layer.field->name + FieldKind(*layer.field) +
        (layer.field->values.components > 1 ? ", " + ComponentName(layer) : std::string()) +
        pixels);
  }
  AddTime(table, shot.input);
  table.Row("size", "{} x {}", frame.width, frame.height);
  const FrameCounters& pixels = frame.counters;
  table.Row(
    "pixels", "{} exact, {} nothing, {} unknown", pixels.exact, pixels.nothing, pixels.unknown);
  table.Row("non-finite", "{}", pixels.nonFinite);
  table.Row("values", values ? Short((*values)[0]) + " to " + Short((*values)[1]) : "none");
  if (pixels.numericHits + pixels.undecidedHits + pixels.cutOff > 0)
  {
    table.Row("hits", "{} numeric, {} undecided, {} rays cut off", pixels.numericHits,
      pixels.undecidedHits, pixels.cutOff);
  }
  if (shot.samples > 1)
  {
    table.Row("smoothed", "{} pixels", looks.Refined());
  }
  if (pixels.floatCheck.points > 0)
  {
    table.Row("float", "at most {} from double at {} pixels evaluated in both",
      Short(pixels.floatCheck.largest), pixels.floatCheck.points);
  }
  debug.AddTo(table);
  AddStages(table, stopwatch);
  table.Print();
}

void WarnOf(const Frame& frame)
{
  if (frame.counters.exact == 0 && frame.counters.unknown == 0)
  {
    Warn("no pixel meets the mesh on a surface; the picture shows the background alone");
  }
  if (frame.counters.unknown > 0)
  {
    Warn(std::to_string(frame.counters.unknown) +
      " pixels could not be decided and are shown as unknown");
  }
  if (frame.counters.cutOff > 0)
  {
    Warn(std::to_string(frame.counters.cutOff) + " rays meet more than " +
      std::to_string(Sheets::kMost) + " translucent surfaces; what is behind is not shown");
  }
}

/// A file of another kind than its name says would mislead whoever opens it.
void CheckSuffix(const char* option, const std::string& file, const char* suffix)
{
  if (!file.empty() && std::filesystem::path(file).extension() != suffix)
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
  CheckSuffix("--buffers", options.buffers, ".vti");
  DebugOptions debug = options.debug;
  debug.Check(options.shot.samples);
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.shot, stopwatch);

  Buffer wanted = NeedsOfLooks(shot) | debug.Needs();
  if (!options.buffers.empty())
  {
    wanted = wanted | UsualBuffers();
  }
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
  const auto values = ValueRange(frame, -std::numeric_limits<double>::infinity());
  stopwatch.Stage("trace+colour");

  WritePng(options.output, frame.width, frame.height, options.shot.colors.Flatten(frame));
  if (!options.buffers.empty())
  {
    WriteBuffers(options.buffers, frame, shot.input.model->SourceCells());
  }
  stopwatch.Stage("write");

  WarnOf(frame);
  if (common.json)
  {
    PrintJson(shot, frame, values, looks, debug, stopwatch);
  }
  else
  {
    PrintTable(shot, frame, values, looks, debug, stopwatch);
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
  AddText(command, "-o,--output", options->output, "IMAGE.png", "PNG image to write").Required();
  AddText(command, "--buffers", options->buffers, "OUT.vti",
    "Also write what was found at each pixel: value, position, normal, xi, element, depth, "
    "verdict, layer, colour");
  AddText(
    command, "--contours", options->contours, "N|v1,v2,...", "Contour lines (not available yet)");
}
} // namespace pixelexact
