// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnShot.h"

#include "Processes.h"
#include "RenderOptions.h"
#include "SharedTrace.h"
#include "VectorCanvas.h"

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
  Pipeline pipeline = Colors->MakePipeline();
  Told.AddTo(pipeline, shot, *Colors, Pixels);
  if (options.contours.AreGiven())
  {
    Lines.emplace(options.contours, options.shot.colors, shot, *Colors, Pixels);
    // Labels stand in gaps of the pixels' lines, undecided pixels in the pixels.
    if (paths && !options.contours.Labels() && !options.contours.Style().showUndecided)
    {
      Paths = PathsOfContours(shot, Lines->ValuesOf(0));
    }
    Lines->AddTo(pipeline, !Paths);
  }
  Repaint(shot.scene, shot.MakeCamera(), pipeline, Pixels);
  Told.Count(Pixels);
  if (Lines)
  {
    Lines->DrawLabels(shot, options.font.Choice(), Pixels);
    TheFound.contours = Lines->Found(Pixels);
  }
  if (options.outline.IsAsked())
  {
    options.outline.Draw(shot, Pixels);
  }
  TheFound.values = ValueRange(Pixels, -std::numeric_limits<double>::infinity());
  if (!Told.IsInPlace() && !options.contours.Only())
  {
    TheFound.beyond = CountBeyond(Pixels, Colors->Ranges(), options.shot.colors.Logarithm());
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
  if (Paths)
  {
    canvas.Clip(Pixels.width, Pixels.height);
    for (const ContourPath& path : *Paths)
    {
      canvas.Line(path.points, Options.contours.Style().width, Lines->ColorOf(0, path.value));
    }
    canvas.Unclip();
  }
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
