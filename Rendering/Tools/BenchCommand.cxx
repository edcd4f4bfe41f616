// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Json.h"
#include "KernelTime.h"
#include "Report.h"
#include "Shot.h"

#include "Core/Base/Error.h"
#include "Core/Element/Kernels.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
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
};

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

struct Measured
{
  std::vector<double> frames; ///< seconds each
  std::int64_t points = 0;    ///< located and evaluated in one frame
  double kernel = 0.0;        ///< median seconds of the bare kernel for as many
};

Measured Measure(const Shot& shot, const BenchOptions& options)
{
  const Camera camera = shot.MakeCamera();
  // Warms the caches, and tells the range, which is no part of a frame.
  const Frame first =
    Trace(shot.scene, camera, {}, { Buffer::Value | Buffer::Verdict, Buffer::None });
  const ColorMapping colors = options.shot.colors.MappingOver(options.shot.colors.RangeFor(first));

  Measured measured;
  measured.points = first.counters.exact;
  std::vector<double> kernels;
  ProgressLine line("measuring");
  for (int i = 0; i < options.repeat; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    (void)Trace(shot.scene, camera, { &colors });
    measured.frames.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    kernels.push_back(KernelSeconds(shot.scene.field->values, measured.points));
    line(static_cast<double>(i + 1) / options.repeat);
  }
  measured.kernel = Median(kernels);
  return measured;
}

void Bench(const BenchOptions& options, const CommonOptions& common)
{
  if (options.shot.input.files.empty())
  {
    throw Unsupported("bench without INPUT is not available yet; name a mesh file");
  }
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.shot, stopwatch);
  const Measured measured = Measure(shot, options);
  const double median = Median(measured.frames);
  const auto points = static_cast<double>(measured.points);
  const double perSecond = points / median;
  const double ratio = measured.points > 0 ? median / measured.kernel : 0.0;
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
    summary.Add("kernel_seconds", measured.kernel).Add("ratio_to_kernel", ratio);
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
    Short(measured.kernel) + " s for as many bare evaluations; the frame takes " + Short(ratio) +
      " times as long");
  AddStages(table, stopwatch);
  table.Print();
}
} // namespace

void AddBenchCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  CLI::App* command = program.add_subcommand(
    "bench", "Time frames of a cut, against the bare evaluation of as many points");
  const auto options = std::make_shared<BenchOptions>();
  options->shot.AddTo(*command);
  command->get_option("INPUT")->required(false);
  command->add_option("--repeat", options->repeat, "Frames to time (default: 5)")
    ->type_name("N")
    ->check(CLI::Range(1, 1000000));
  command->callback(
    [options, &common, &action] { action = [options, &common] { Bench(*options, common); }; });
}
} // namespace pixelexact
