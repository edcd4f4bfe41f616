// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/Report.h"
#include "Bench/BenchFigures.h"
#include "Bench/ContourTime.h"
#include "Bench/FrameTime.h"
#include "Scene/ContourOptions.h"
#include "Scene/Shot.h"
#include "Scene/ShotAppearance.h"
#include "Trade/PaperReport.h"

#include "Core/Base/Error.h"
#include "Core/Element/Kernels.h"
#include "Trace/Contours/LayerBounds.h"

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>

namespace pixelexact
{
namespace
{
struct BenchOptions
{
  ShotOptions shot;
  ContourOptions contours;
  int repeat = 5;
  int largest = 200000; ///< elements of the made meshes
  std::string paper;    ///< how much of the paper's evaluation; empty: none
  std::string folder = "paper";
};

struct Measured
{
  FrameTime time;
  FrameCounters first; ///< of the first frame, which computes elements' bounds and trees
  std::optional<ContourTime> contours;
};

/// Refuses options that have no effect on generated meshes.
void CheckWithoutInput(const CLI::App& command)
{
  constexpr std::array<std::string_view, 7> kUsed{ "--size", "--repeat", "--elements", "--threads",
    "--json", "--config", "--no-config" };

  for (const std::string& name : OptionsGiven(command))
  {
    if (std::ranges::find(kUsed, name) == kUsed.end())
    {
      throw UsageError(name + " has no effect without an INPUT; name one, or leave it out");
    }
  }
}

Measured Measure(const Shot& shot, const BenchOptions& options)
{
  // The first frame determines the range and is not measured.
  const Frame first = Trace(ViewOf(options.shot.colors, &options.contours, shot), Buffer::None);
  ShotAppearance plain(options.shot.colors, nullptr, shot, first);
  const Pipeline pipeline = plain.GetPainter().MakePipeline();
  const Scene& scene = plain.GetView().scene;
  const Camera camera = shot.MakeCamera();
  ProgressLine line("measuring");
  Measured measured{ MeasureFrames(scene, camera, pipeline, options.repeat,
                       [&line](double part) { line(part); }),
    first.counters, std::nullopt };
  if (options.contours.AreGiven())
  {
    ShotAppearance withContours(
      options.shot.colors, &options.contours, shot, first, std::make_shared<ContourBounds>());
    Painter& painter = withContours.GetPainter();
    measured.contours = MeasureContours(scene, camera, pipeline, painter.MakePipeline(),
      options.repeat, [&painter] { return painter.Contours()->Counters(); });
  }
  return measured;
}

/// Runs the paper's evaluation on generated meshes and, with an INPUT, on its data.
void BenchPaper(const BenchOptions& options, const CommonOptions& common)
{
  const bool hasInput = !options.shot.input.files.empty();
  for (const std::string& name : OptionsGiven(*options.shot.command))
  {
    constexpr std::array<std::string_view, 11> kUsed{ "--paper", "--output", "--threads", "--json",
      "--config", "--no-config", "--field", "--component", "--plane", "--size", "--time-step" };
    if (std::ranges::find(kUsed, name) == kUsed.end() ||
      (!hasInput && std::ranges::find(kUsed, name) >= kUsed.begin() + 6))
    {
      throw UsageError(name + " has no effect with --paper" +
        (hasInput ? std::string() : " without an INPUT") + "; leave it out");
    }
  }
  const PaperExtent extent = options.paper == "whole" ? PaperExtent::Whole : PaperExtent::Quick;
  Stopwatch stopwatch;
  PaperResults results;
  if (hasInput)
  {
    const Shot shot = Prepare(options.shot, stopwatch);
    MeasurePaperErrors(shot, extent, results);
    stopwatch.Stage("data");
  }
  {
    ProgressLine line("measuring");
    MeasurePaper(
      extent, [&line](double part) { line(part); }, results);
  }
  stopwatch.Stage("made meshes");
  WritePaper(options.folder, results);
  Note("written to '" + options.folder + "'");
  if (common.json)
  {
    nlohmann::ordered_json summary = ToJson(results);
    summary["threads"] =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    summary["seconds"] = ToJson(stopwatch);
    Print(summary);
    return;
  }
  PrintPaper(results);
  Table table;
  AddStages(table, stopwatch);
  table.Print();
}

void Bench(const BenchOptions& options, const CommonOptions& common)
{
  if (!options.paper.empty())
  {
    BenchPaper(options, common);
    return;
  }
  if (IsGiven(*options.shot.command, "--output"))
  {
    throw UsageError("--output has no effect without --paper; leave it out");
  }
  if (options.shot.input.files.empty())
  {
    CheckWithoutInput(*options.shot.command);
    RunFigures({ options.shot.size, options.repeat, options.largest, common.json });
    return;
  }
  if (IsGiven(*options.shot.command, "--elements"))
  {
    throw UsageError("--elements has no effect on an INPUT; leave one of them out");
  }
  if (options.contours.Labels())
  {
    throw UsageError("--contour-labels has no effect on times; leave it out");
  }
  options.shot.CheckRangeOfOne();
  options.contours.Check(options.shot.MakeLayers());
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.shot, stopwatch);
  if (shot.scene.layers.front().field == nullptr)
  {
    throw Error("the input has no field to time; name the file of a field");
  }
  const auto [measured, first, contours] = Measure(shot, options);
  const double median = measured.Frame();
  const auto points = static_cast<double>(measured.points);
  const double perSecond = points / median;
  const double ratio = measured.Ratio();
  const auto threads =
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);

  if (common.json)
  {
    nlohmann::ordered_json summary{ { "elements", shot.input.model->GetMesh().Elements() },
      { "field", shot.scene.layers.front().field->name },
      { "component", ComponentName(shot.scene.layers.front()) } };
    AddTime(summary, shot.input);
    summary.update({ { "width", shot.size.width }, { "height", shot.size.height },
      { "points", measured.points }, { "threads", threads },
      { "instruction_set", InstructionSet() }, { "unknown", first.unknown },
      { "first_frame_seconds", first.seconds }, { "frame_seconds", measured.frames },
      { "frame_processor_seconds", measured.busy }, { "median_frame_seconds", median },
      { "points_per_second", perSecond }, { "kernel_seconds", measured.Kernel() },
      { "least_kernel_seconds", std::ranges::min(measured.kernels) }, { "ratio_to_kernel", ratio },
      { "stages", ToJson(measured.stages) }, { "staged_frame_seconds", measured.staged },
      { "index_bytes", shot.scene.locator->Index().MemoryUsage() },
      { "tree_bytes", shot.scene.locator->Index().TreeBytes() },
      { "seconds", ToJson(stopwatch) } });
    if (contours)
    {
      summary["contours"] = ToJson(*contours);
    }
    Print(summary);
    return;
  }
  Table table;
  table.Row("elements", "{}", shot.input.model->GetMesh().Elements());
  table.Row(
    "field", shot.scene.layers.front().field->name + FieldKind(*shot.scene.layers.front().field));
  AddTime(table, shot.input);
  table.Row("size", "{} x {}", shot.size.width, shot.size.height);
  table.Row("threads", "{}, {}", threads, InstructionSet());
  table.Row("points", "{} exact pixels", measured.points);
  table.Row("frame", "{} s, median of {}; {} points/s; the first {} s", Short(median),
    measured.frames.size(), Short(perSecond), Short(first.seconds));
  table.Row("kernel", "{} s for as many bare evaluations; the frame takes {} times as long",
    Short(measured.Kernel()), Short(ratio));
  table.Row("tiles", Shares(measured.stages));
  if (contours)
  {
    table.Row("contours", Describe(*contours));
  }
  AddStages(table, stopwatch);
  table.Print();
}
} // namespace

void AddBenchCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = AddCommand(program, "bench",
    "Time frames of a cut, against the bare evaluation of as many points, and with --contours "
    "against "
    "frames that have them; without INPUT, of made meshes",
    [options, &common, &action] { action = [options, &common] { Bench(*options, common); }; });
  options->shot.AddTo(command);
  options->contours.AddTo(command);
  Bind(command, "--repeat", options->repeat);
  Bind(command, "--elements", options->largest);
  Bind(command, "--paper", [options](const std::string& text) { options->paper = text; });
  Bind(command, "--output", options->folder);
}
} // namespace pixelexact
