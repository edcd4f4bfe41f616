// SPDX-License-Identifier: BSD-3-Clause
#include "BufferOptions.h"
#include "Command.h"
#include "ContourFile.h"
#include "DebugOptions.h"
#include "Looks.h"
#include "Numbers.h"
#include "Output.h"
#include "Picture.h"
#include "RenderReport.h"
#include "Report.h"
#include "Shot.h"

#include "Core/Base/Error.h"
#include "Trace/Tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>

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
  ContourFileOptions lines;
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

/// A number of values, evenly spaced inside of those seen, or values. Throws UsageError.
std::vector<double> ReadValues(
  const std::string& text, const std::optional<std::array<double, 2>>& seen)
{
  int count = 0;
  if (ParseInteger(text, count) && count > 0)
  {
    std::vector<double> values;
    for (int i = 1; seen && i <= count; ++i)
    {
      values.push_back((*seen)[0] + ((*seen)[1] - (*seen)[0]) * i / (count + 1));
    }
    return values;
  }
  std::vector<double> values;
  std::stringstream words(text);
  for (std::string word; std::getline(words, word, ',');)
  {
    double value = 0.0;
    if (!ParseNumber(word, value) || !std::isfinite(value))
    {
      throw UsageError("--contours: '" + text + "' is no number of contours and no list of values");
    }
    values.push_back(value);
  }
  return values;
}

void Render(const RenderOptions& options, const CommonOptions& common)
{
  if (!options.contours.empty() && options.lines.file.empty())
  {
    throw Unsupported("--contours are not drawn yet; leave it out, or write them with "
                      "--contours-output");
  }
  CheckSuffix("--output", options.output, ".png");
  CheckSuffix("--buffers", options.buffers.File(), ".vti");
  CheckSuffix("--contours-output", options.lines.file, ".vtp");
  const std::vector<std::string> outputs{ options.output, options.buffers.File(),
    options.lines.file };
  CheckStandardOutput(outputs, common.json);
  CheckOutput("--output", options.output, options.shot.input.files);
  CheckOutput("--buffers", options.buffers.File(), options.shot.input.files);
  CheckOutput("--contours-output", options.lines.file, options.shot.input.files);
  static_cast<void>(ReadValues(options.contours, {}));
  options.buffers.Check();
  DebugOptions debug = options.debug;
  debug.Check(options.shot.samples, options.shot.MakeLayers());
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.shot, stopwatch);
  if (!options.lines.file.empty())
  {
    CheckContourSurfaces(shot);
  }

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
  if (!options.lines.file.empty())
  {
    WriteContours(options.lines, shot,
      std::vector(shot.scene.layers.size(), ReadValues(options.contours, found.values)));
    stopwatch.Stage("contours");
  }

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
  const AddedOption contours = AddText(command, "--contours", options->contours, "N|v1,v2,...",
    "Contours: so many, evenly spaced inside of the values seen, or of these values (not drawn "
    "yet)");
  const AddedOption lines = AddText(command, "--contours-output", options->lines.file, "LINES.vtp",
    "Write the contours on planes and quadrics as polylines with proven topology")
                              .Needs(contours);
  AddRead(
    command, "--contours-tolerance",
    [&options = *options](const std::string& text)
    {
      double length = 0.0;
      if (!ParseNumber(text, length) || !(length > 0.0 && std::isfinite(length)))
      {
        Refuse("--contours-tolerance", text, "a length greater than 0");
      }
      options.lines.tolerance = length;
    },
    "LENGTH", "How far their chords may be from the curves (default: 1e-4 of the mesh's diagonal)")
    .Needs(lines);
}
} // namespace pixelexact
