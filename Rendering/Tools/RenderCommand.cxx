// SPDX-License-Identifier: BSD-3-Clause
#include "BufferOptions.h"
#include "Command.h"
#include "ContourDrawing.h"
#include "ContourFile.h"
#include "ContourOptions.h"
#include "DebugOptions.h"
#include "Figure.h"
#include "Looks.h"
#include "Output.h"
#include "Picture.h"
#include "PictureName.h"
#include "RenderReport.h"
#include "Report.h"
#include "Shot.h"

#include "Core/Base/Error.h"
#include "Trace/Tracer.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

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
  ContourOptions contours;
  ContourFileOptions lines;
  FigureOptions figure;
};

/// A file of another kind than its name says would mislead whoever opens it.
void CheckSuffix(const char* option, const std::string& file, const char* suffix)
{
  if (!file.empty() && !IsStandardStream(file) && std::filesystem::path(file).extension() != suffix)
  {
    throw UsageError(
      std::string(option) + ": '" + file + "' is written as " + suffix + "; name it so");
  }
}

/// The picture alone, or with a figure around it, which says where it comes from.
void WritePicture(const RenderOptions& options, const Shot& shot, const Looks& looks,
  const Frame& frame, const std::string& file, const RepeatedCommand& command)
{
  if (!options.figure.IsAsked())
  {
    WritePng(file, frame.width, frame.height, options.shot.colors.Flatten(frame));
    return;
  }
  const ImageSize& size = options.shot.size;
  const bool bars = !options.contours.Only() || options.contours.ByMap();
  const FrameCounters& pixels = frame.counters;
  WritePng(file, size.width, size.height,
    options.figure.Draw(size, shot, looks, frame, options.shot.colors, bars),
    { { "Source", DescribeFiles(options.shot.input.files) }, { "Command", command.Text() },
      { "Pixels",
        fmt::format(
          "{} exact, {} nothing, {} unknown", pixels.exact, pixels.nothing, pixels.unknown) } });
}

void Render(const RenderOptions& options, const CommonOptions& common)
{
  const std::string picture =
    options.output.empty() ? PictureNamedAfter(options.shot.input.files.front()) : options.output;
  CheckSuffix("--output", picture, ".png");
  CheckSuffix("--buffers", options.buffers.File(), ".vti");
  CheckSuffix("--contours-output", options.lines.file, ".vtp");
  const std::vector<std::string> outputs{ picture, options.buffers.File(), options.lines.file };
  CheckStandardOutput(outputs, common.json);
  CheckOutput("--output", picture, options.shot.input.files);
  CheckOutput("--buffers", options.buffers.File(), options.shot.input.files);
  CheckOutput("--contours-output", options.lines.file, options.shot.input.files);
  if (!options.lines.file.empty() && !options.contours.AreGiven())
  {
    throw UsageError("--contours-output: there are no contours to write; give --contours");
  }
  options.buffers.Check();
  DebugOptions debug = options.debug;
  const std::vector<LayerSettings> layers = options.shot.MakeLayers();
  debug.Check(options.shot.samples, layers);
  options.contours.Check(layers);
  ShotOptions asked = options.shot;
  if (options.figure.IsAsked())
  {
    if (debug.IsInPlace())
    {
      throw UsageError("--figure has no bar for the colours of --show and --owners; leave it out");
    }
    options.figure.Check(asked.size);
    asked.size = options.figure.PictureSize(asked.size);
  }
  Stopwatch stopwatch;
  const Shot shot = Prepare(asked, stopwatch);
  if (!options.lines.file.empty())
  {
    CheckContourSurfaces(shot);
  }

  const bool hasField = shot.scene.layers.front().field != nullptr;
  const Buffer wanted =
    NeedsOfLooks(shot) | debug.Needs() | options.contours.Needs() | options.buffers.Needs(hasField);
  Frame frame = [&]
  {
    ProgressLine line("tracing");
    return Trace(shot.scene, shot.MakeCamera(), {}, { .centres = wanted }, std::ref(line));
  }();
  // Colours afterwards, because the default range is that of the values found.
  Looks looks(options.shot.colors, shot, frame);
  Pipeline pipeline = looks.MakePipeline();
  debug.AddTo(pipeline, shot, looks, frame);
  std::optional<ContourDrawing> contours;
  if (options.contours.AreGiven())
  {
    contours.emplace(options.contours, options.shot.colors, shot, looks, frame);
    contours->AddTo(pipeline);
  }
  Repaint(shot.scene, shot.MakeCamera(), pipeline, frame);
  debug.Count(frame);
  Found found;
  if (contours)
  {
    contours->DrawLabels(shot, frame);
    found.contours = contours->Found(frame);
  }
  found.values = ValueRange(frame, -std::numeric_limits<double>::infinity());
  if (!debug.IsInPlace() && !options.contours.Only())
  {
    found.beyond = CountBeyond(frame, looks.Ranges(), options.shot.colors.Logarithm());
  }
  stopwatch.Stage("trace+colour");

  RepeatedCommand command{ common.words, shot.chosen };
  if (options.output.empty())
  {
    command.chosen.insert(command.chosen.end(), { "--output", picture });
  }
  WritePicture(options, shot, looks, frame, picture, command);
  if (!options.buffers.File().empty())
  {
    WriteBuffers(options.buffers.File(), options.buffers.Arrays(), frame,
      shot.input.model->SourceCells(),
      contours ? std::span(contours->Verdicts()) : std::span<const std::uint8_t>());
  }
  stopwatch.Stage("write");
  if (!options.lines.file.empty())
  {
    WriteContours(options.lines, shot, found.contours->values);
    stopwatch.Stage("contours");
  }

  if (options.output.empty())
  {
    Note("written to '" + picture + "'");
  }
  WarnOf(frame, found);
  if (common.json)
  {
    PrintJson(shot, frame, found, looks, debug, command, stopwatch);
  }
  else
  {
    PrintTable(shot, frame, found, looks, debug, command, stopwatch,
      std::ranges::any_of(outputs, IsStandardStream));
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
  options->contours.AddTo(command);
  options->debug.AddTo(command);
  AddText(command, "-o,--output", options->output, "IMAGE.png",
    "PNG image to write; - for standard output (default: named after the input, in the current "
    "folder; a file of that name is written over where pixelexact made it)");
  options->buffers.AddTo(command);
  options->lines.AddTo(command);
  options->figure.AddTo(command);
}
} // namespace pixelexact
