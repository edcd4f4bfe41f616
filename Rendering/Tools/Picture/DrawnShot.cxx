// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/DrawnShot.h"

#include "Base/Processes.h"
#include "Drawing/VectorCanvas.h"
#include "Picture/EdgePaths.h"
#include "Picture/RenderOptions.h"
#include "Picture/SharedTrace.h"

#include "Trace/StridedFrame.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace pixelexact
{
Frame TraceShot(const RenderOptions& options, const Shot& shot, const Progress& progress)
{
  const bool hasField = shot.scene.layers.front().field != nullptr;
  const Buffer wanted = NeedsOfLooks(shot) | options.debug.Needs() | options.contours.Needs() |
    options.buffers.Needs(hasField) | options.outline.Needs();
  if (const int stride = options.knobs.Stride(); stride > 1)
  {
    return TraceStrided(shot.scene, shot.MakeCamera(), wanted, stride, progress);
  }
  return AreSeveralProcesses()
    ? TraceTogether(shot, wanted, progress)
    : Trace(shot.scene, shot.MakeCamera(), {}, { .centres = wanted }, progress);
}

DrawnShot::DrawnShot(const RenderOptions& options, const Shot& shot, Frame traced, bool paths)
  : Options(options)
  , Of(shot)
  , Pixels(std::move(traced))
  , Told(options.debug)
{
  // Colours after the rays, because the default range is that of the values found.
  Colors.emplace(options.shot.colors, shot, Pixels);
  std::optional<std::vector<std::vector<CanvasPoint>>> edges;
  if (paths && shot.edges)
  {
    edges = shot.edgesByKind ? std::nullopt : PathsOfEdges(shot, Pixels);
    TellWhatStays("element edges", edges.has_value());
  }
  Pipeline pipeline = Colors->MakePipeline(!edges);
  Told.AddTo(pipeline, shot, *Colors, Pixels);
  std::optional<std::vector<ContourPath>> contours;
  if (options.contours.AreGiven())
  {
    Lines.emplace(options.contours, options.shot.colors, shot, *Colors, Pixels);
    // Undecided pixels are in the pixels.
    if (paths && !options.contours.Style().showUndecided)
    {
      contours = PathsOfContours(shot, Lines->ValuesOf(0));
    }
    if (paths)
    {
      TellWhatStays("contours", contours.has_value());
    }
    Lines->AddTo(pipeline, !contours);
  }
  Repaint(shot.scene, shot.MakeCamera(), pipeline, Pixels);
  Told.Count(Pixels);
  if (edges)
  {
    AddLines(*edges, shot.edges->width, shot.edges->colors.front());
  }
  if (contours)
  {
    AddContours(*contours);
  }
  else if (Lines)
  {
    Lines->DrawLabels(shot, options.font.Choice(), Pixels);
  }
  if (Lines)
  {
    TheFound.contours = Lines->Found(Pixels);
  }
  if (options.outline.IsAsked() && paths)
  {
    AddLines(options.outline.Paths(shot, Pixels), options.outline.LineWidth(),
      options.outline.LineColor());
  }
  else if (options.outline.IsAsked())
  {
    options.outline.Draw(shot, Pixels);
  }
  TheFound.knobs = { options.knobs.Stride(), shot.truncated };
  TheFound.values = ValueRange(Pixels, -std::numeric_limits<double>::infinity());
  if (!Told.IsInPlace() && !options.contours.Only())
  {
    TheFound.beyond = CountBeyond(Pixels, Colors->Ranges(), options.shot.colors.Logarithm());
  }
}

void DrawnShot::TellWhatStays(const char* what, bool arePaths)
{
  if (!arePaths)
  {
    Staying.emplace_back(what);
  }
}

void DrawnShot::AddLines(
  std::vector<std::vector<CanvasPoint>> paths, double width, const Rgba& color)
{
  for (std::vector<CanvasPoint>& path : paths)
  {
    Over.lines.push_back({ std::move(path), width, color });
  }
}

void DrawnShot::AddContours(const std::vector<ContourPath>& contours)
{
  Over.labels = Lines->PlaceLabels(Of, Options.font.Choice(), Pixels);
  Over.labelSize = Options.contours.Labels().value_or(0);
  for (const ContourPath& path : contours)
  {
    AddLines(PartsBeside(Over.labels, path.points), Options.contours.Style().width,
      Lines->ColorOf(0, path.value));
  }
}

void DrawnShot::DrawFigure(Canvas& canvas) const
{
  FigureContent content{ Of, *Colors, Pixels, Options.shot.colors, true, {} };
  content.bars = !Options.contours.Only() || Options.contours.ByMap();
  if (const auto color = Told.UndecidedMark())
  {
    content.marks.push_back({ *color, "undecided" });
  }
  Options.figure.Draw(canvas, Options.shot.size, content);
}

Image DrawnShot::Picture() const
{
  const ColorOptions& colors = Options.shot.colors;
  if (!Options.figure.IsAsked())
  {
    return colors.Flatten(Pixels);
  }
  const ImageSize& size = Options.shot.size;
  RasterCanvas canvas(size.width, size.height, colors.BackgroundColor(),
    Options.figure.FontOf(size), Options.font.Choice());
  canvas.Place(colors.Flatten(Pixels));
  DrawFigure(canvas);
  return canvas.Picture();
}

std::string DrawnShot::Vectors(
  PictureFormat format, const PictureTexts& texts, const std::string& file) const
{
  const ColorOptions& colors = Options.shot.colors;
  const ImageSize& size = Options.shot.size;
  VectorCanvas canvas(format, size.width, size.height, Options.Dpi().value_or(kUsualDpi),
    colors.BackgroundColor(), Options.figure.FontOf(size), Options.font.Choice());
  canvas.Place(colors.Flatten(Pixels));
  Over.Draw(canvas, Pixels.width, Pixels.height);
  if (Options.figure.IsAsked())
  {
    DrawFigure(canvas);
  }
  return canvas.Finish(texts, file);
}

std::string DrawnShot::PixelsText() const
{
  const FrameCounters& pixels = Pixels.counters;
  return fmt::format(
    "{} exact, {} nothing, {} unknown", pixels.exact, pixels.nothing, pixels.unknown);
}
} // namespace pixelexact
