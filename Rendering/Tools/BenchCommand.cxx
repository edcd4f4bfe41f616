// SPDX-License-Identifier: BSD-3-Clause
#include "BenchFigures.h"
#include "Command.h"
#include "FrameTime.h"
#include "Json.h"
#include "Report.h"
#include "Shot.h"

#include "Core/Base/Error.h"
#include "Core/Element/Kernels.h"

#include <tbb/global_control.h>

#include <iostream>
#include <memory>

namespace pixelexact
{
namespace
{
struct BenchOptions
{
  ShotOptions shot;
  int repeat = 5;
  int largest = 200000; ///< elements of the made meshes
};

FrameTime Measure(const Shot& shot, const BenchOptions& options)
{
  const Camera camera = shot.MakeCamera();
  // Tells the range, which is no part of a frame.
  const Frame first =
    Trace(shot.scene, camera, {}, { Buffer::Value | Buffer::Verdict, Buffer::None });
  const ColorMapping colors = options.shot.colors.MappingOver(options.shot.colors.RangeFor(first));
  ProgressLine line("measuring");
  return MeasureFrames(
    shot.scene, camera, { &colors }, options.repeat, [&line](double part) { line(part); });
}

void Bench(const BenchOptions& options, const CommonOptions& common)
{
  if (options.shot.input.files.empty())
  {
    RunFigures(
      { options.shot.size, options.repeat, options.largest, common.json, options.shot.colors });
    return;
  }
  if (options.shot.field.empty())
  {
    throw UsageError("--field is required with INPUT");
  }
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.shot, stopwatch);
  const FrameTime measured = Measure(shot, options);
  const double median = measured.Frame();
  const auto points = static_cast<double>(measured.points);
  const double perSecond = points / median;
  const double ratio = measured.Ratio();
  const auto threads =
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);

  if (common.json)
  {
    json::Object summary;
    summary.Add("elements", shot.input.model->GetMesh().Elements());
    summary.Add("field", shot.scene.field->name).Add("component", ComponentName(shot.scene));
    AddTime(summary, shot.input);
    summary.Add("width", shot.size.width).Add("height", shot.size.height);
    summary.Add("points", measured.points).Add("threads", threads);
    summary.Add("instruction_set", InstructionSet()).Add("frame_seconds", measured.frames);
    summary.Add("median_frame_seconds", median).Add("points_per_second", perSecond);
    summary.Add("kernel_seconds", measured.Kernel()).Add("ratio_to_kernel", ratio);
    summary.Add("stages", ToJson(measured.stages)).Add("staged_frame_seconds", measured.staged);
    summary.Add("seconds", ToJson(stopwatch));
    std::cout << summary.String() << '\n';
    return;
  }
  Table table;
  table.Row("elements", std::to_string(shot.input.model->GetMesh().Elements()));
  table.Row("field", shot.scene.field->name + FieldKind(*shot.scene.field));
  AddTime(table, shot.input);
  table.Row("size", std::to_string(shot.size.width) + " x " + std::to_string(shot.size.height));
  table.Row("threads", std::to_string(threads) + ", " + InstructionSet());
  table.Row("points", std::to_string(measured.points) + " exact pixels");
  table.Row("frame",
    Short(median) + " s, median of " + std::to_string(measured.frames.size()) + "; " +
      Short(perSecond) + " points/s");
  table.Row("kernel",
    Short(measured.Kernel()) + " s for as many bare evaluations; the frame takes " + Short(ratio) +
      " times as long");
  table.Row("tiles", Shares(measured.stages));
  AddStages(table, stopwatch);
  table.Print();
}
} // namespace

void AddBenchCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<BenchOptions>();
  CLI::App& command = AddCommand(program, "bench",
    "Time frames of a cut, against the bare evaluation of as many points; without INPUT, "
    "of made meshes",
    [options, &common, &action] { action = [options, &common] { Bench(*options, common); }; });
  options->shot.AddTo(command, false);
  AddInteger(command, "--repeat", options->repeat, 1, 1000000, "N", "Frames to time (default: 5)");
  AddInteger(command, "--elements", options->largest, 1, 10000000, "N",
    "Without INPUT: the most elements of a made mesh (default: 200000)");
}
} // namespace pixelexact
