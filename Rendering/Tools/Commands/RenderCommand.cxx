// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Command.h"
#include "Base/Output.h"
#include "Base/Processes.h"
#include "Base/Report.h"
#include "Drawing/ImageFile.h"
#include "Picture/Animation.h"
#include "Picture/DrawnShot.h"
#include "Picture/PictureFile.h"
#include "Picture/RenderOptions.h"
#include "Picture/RenderReport.h"
#include "Picture/SharedTrace.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace pixelexact
{
namespace
{
void Render(RenderOptions options, const CommonOptions& common)
{
  if (options.animation.IsAsked(options.shot.input))
  {
    RefuseSeveralProcesses("an animation");
    RenderAnimation(std::move(options), common);
    return;
  }
  const std::string picture =
    options.output.empty() ? PictureNamedAfter(options.shot.input.files.front()) : options.output;
  const std::vector<std::string> outputs{ picture, options.buffers.File(), options.lines.file };
  CheckStandardOutput(outputs, common.json);
  options.Check(picture);
  CheckForSeveralProcesses(options);
  Stopwatch stopwatch;
  const Shot shot = Prepare(options.OfPicture(), stopwatch);
  if (!options.lines.file.empty())
  {
    CheckContourSurfaces(shot);
  }
  Frame traced = [&]
  {
    ProgressLine line("tracing");
    return TraceShot(options, shot, std::ref(line));
  }();
  stopwatch.Stage("rays");
  if (!IsFirstProcess())
  {
    return; // the first one draws what all have traced
  }
  const bool vectors = IsVector(FormatOf("--output", picture));
  const DrawnShot drawn(options, shot, std::move(traced), vectors);
  if (!drawn.InPixels().empty())
  {
    Note(Listed(drawn.InPixels()) +
      ": in the picture's pixels; as paths there are proven contours and edges that are not too "
      "dense, of one plane alone");
  }
  stopwatch.Stage("colours");

  RepeatedCommand command{ common.words, shot.chosen };
  if (options.output.empty())
  {
    command.chosen.insert(command.chosen.end(), { "--output", picture });
  }
  WriteBytes(picture, EncodePicture(options, drawn, picture, command, stopwatch));
  if (const std::string& buffers = options.buffers.File(); !buffers.empty())
  {
    WriteBytes(buffers, EncodeBuffersOf(options, shot, drawn, buffers));
  }
  stopwatch.Stage("write");
  const Found& found = drawn.WhatIsFound();
  if (!options.lines.file.empty())
  {
    WriteContours(options.lines, shot, found.contours->values);
    stopwatch.Stage("contours");
  }

  if (options.output.empty())
  {
    Note("written to '" + picture + "'");
  }
  WarnOf(shot, drawn.GetFrame(), found);
  if (common.json)
  {
    PrintJson(
      shot, drawn.GetFrame(), found, drawn.GetAppearance(), drawn.Debug(), command, stopwatch);
  }
  else
  {
    PrintTable(shot, drawn.GetFrame(), found, drawn.GetAppearance(), drawn.Debug(), command,
      stopwatch, std::ranges::any_of(outputs, IsStandardStream));
  }
}
} // namespace

void AddRenderCommand(CLI::App& program, const CommonOptions& common, Action& action)
{
  const auto options = std::make_shared<RenderOptions>();
  CLI::App& command =
    AddCommand(program, "render", "Cut a field by surfaces and colour every pixel exactly",
      [options, &common, &action] { action = [options, &common] { Render(*options, common); }; });
  options->AddTo(command);
}
} // namespace pixelexact
