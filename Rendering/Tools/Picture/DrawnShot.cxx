// SPDX-License-Identifier: BSD-3-Clause
#include "Picture/DrawnShot.h"

#include "Base/Processes.h"
#include "Base/Report.h"
#include "Drawing/VectorCanvas.h"
#include "Frames/ContourLabels.h"
#include "Picture/ContourReport.h"
#include "Picture/EdgePaths.h"
#include "Picture/Figure.h"
#include "Picture/RenderOptions.h"
#include "Picture/SharedTrace.h"

#include "Views/VtkLook.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

namespace pixelexact
{
namespace
{
/// Size of the canvas's letters where no text has that size.
constexpr int kNoLetters = 10;
/// Meanings of the colours of EdgeStyle::ByKind, in the order of FaceKind.
constexpr std::array kFaceKinds{ "edge: boundary", "edge: one face", "edge: other sizes",
  "edge: part of a face" };
} // namespace

Frame TraceShot(const RenderOptions& options, const Shot& shot, const Progress& progress)
{
  const bool hasField = shot.scene.layers.front().field != nullptr;
  // The report states the range of visible values.
  const Buffer others = (hasField ? Buffer::Value : Buffer::None) | options.debug.Needs() |
    options.buffers.Needs(hasField) | options.outline.Needs() | options.marks.Needs() |
    options.arrows.Needs() | options.dots.Needs() | options.texture.Needs();
  View view = ViewOf(options.shot.colors, &options.contours, shot);
  view.stride = options.quality.Stride();
  return AreSeveralProcesses() ? TraceTogether(view, others, progress)
                               : Trace(view, others, progress);
}

namespace
{
/// Throws Interrupted in a pass of the tiles.
class InterruptedModule final : public FrameModule
{
public:
  InterruptedModule(const GoesOn& goesOn, FrameModule* rest)
    : GoesOnYet(goesOn)
    , Next(rest)
  {
  }
  [[nodiscard]] SampleNeeds Needs() const override { return {}; }
  void Begin(int /*width*/, int /*height*/) override {}
  void Process(TileVisit& /*tile*/) override
  {
    if (!GoesOnYet())
    {
      throw Interrupted();
    }
  }
  [[nodiscard]] FrameModule* Rest() override { return Next; }

private:
  const GoesOn& GoesOnYet;
  FrameModule* Next;
};

/// The modules that interrupt each pass of a pipeline; the last one is the first of the pipeline.
std::vector<std::unique_ptr<InterruptedModule>> AddInterruption(
  const GoesOn& goesOn, Pipeline& pipeline)
{
  std::vector<std::unique_ptr<InterruptedModule>> passes;
  if (!goesOn || pipeline.modules.empty())
  {
    return passes;
  }
  std::size_t count = 0;
  for (FrameModule* module : pipeline.modules)
  {
    std::size_t own = 0;
    for (FrameModule* pass = module; pass != nullptr; pass = pass->Rest())
    {
      ++own;
    }
    count = std::max(count, own);
  }
  passes.reserve(count);
  while (passes.size() < count)
  {
    FrameModule* const rest = passes.empty() ? nullptr : passes.back().get();
    passes.push_back(std::make_unique<InterruptedModule>(goesOn, rest));
  }
  pipeline.modules.insert(pipeline.modules.begin(), passes.back().get());
  return passes;
}
} // namespace

DrawnShot::DrawnShot(
  const RenderOptions& options, const Shot& shot, Frame traced, bool paths, const GoesOn& goesOn)
  : Options(options)
  , Of(shot)
  , Pixels(std::move(traced))
  , Told(options.debug)
{
  // Colours follow tracing, because the default range is that of the traced values.
  Colors.emplace(options.shot.colors, &options.contours, shot, Pixels);
  Painter& painter = Colors->GetPainter();
  std::optional<std::vector<std::vector<CanvasPoint>>> edges;
  if (paths && shot.appearance.edges)
  {
    edges = shot.appearance.faces != nullptr ? std::nullopt : PathsOfEdges(shot, Pixels);
    ReportUnchanged("element edges", edges.has_value());
  }
  const bool hasContours = painter.Contours() != nullptr;
  std::optional<std::vector<ContourPath>> contours;
  // Marks of undecided pixels stay pixels.
  if (paths && hasContours && painter.Lines()->DrawsUndecided())
  {
    contours = PathsOfContours(shot, painter.Contours()->Values().front());
  }
  if (paths && hasContours)
  {
    ReportUnchanged("contours", contours.has_value());
  }
  Pipeline pipeline = painter.MakePipeline({ .edges = !edges, .contours = !contours });
  Told.AddTo(pipeline, shot, Pixels);
  if (options.texture.IsAsked())
  {
    found_.texture = options.texture.Find(shot, Pixels);
    pipeline.colors.insert(
      std::find(pipeline.colors.begin(), pipeline.colors.end(), painter.Undecided()),
      found_.texture->colors.get());
  }
  const auto interruption = AddInterruption(goesOn, pipeline);
  const View& view = Colors->GetView();
  Repaint(view.scene, view.camera.Make(), pipeline, Pixels);
  Told.Count(Pixels, painter.Undecided());
  if (edges)
  {
    AddLines(*edges, shot.appearance.edges->width, shot.appearance.edges->colors.front());
  }
  if (contours)
  {
    AddContours(*contours);
  }
  else if (painter.Labels())
  {
    Labels = DrawContourLabels(Pixels, shot.MakeCamera(), *painter.Contours(), *painter.Lines(),
      *painter.Labels(), options.font.Choice());
  }
  if (hasContours)
  {
    found_.contours = FindContours(*Colors, Pixels, Labels);
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
  if (options.arrows.IsAsked())
  {
    found_.arrows = options.arrows.Find(shot, Pixels);
  }
  if (options.dots.IsAsked())
  {
    found_.dots = FieldDots::Find(shot, Pixels, *Colors);
  }
  if (options.marks.IsAsked())
  {
    Extremes = ExtremeMarks::Find(shot);
  }
  if (painter.Volumes() != nullptr)
  {
    found_.volume = painter.Volumes()->Counters();
  }
  found_.quality = { options.quality.Stride(), shot.truncated };
  found_.values = ValuesSeen(Pixels, -std::numeric_limits<double>::infinity());
  if (!Told.IsInPlace() && !options.contours.Only())
  {
    found_.beyond = CountBeyond(Pixels, Colors->Ranges(), options.shot.colors.Logarithm());
  }
}

void DrawnShot::ReportUnchanged(const char* what, bool arePaths)
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
  const Painter& painter = Colors->GetPainter();
  if (painter.Labels())
  {
    Over.labels = PlaceContourLabels(Pixels, Of.MakeCamera(), *painter.Contours(), *painter.Lines(),
      *painter.Labels(), Options.font.Choice());
    Over.labelSize = *painter.Labels();
    Labels = static_cast<int>(Over.labels.size());
  }
  for (const ContourPath& path : contours)
  {
    AddLines(PartsBeside(Over.labels, path.points), Options.contours.Style().width,
      painter.Lines()->ColorOf(0, path.value));
  }
}

void DrawnShot::DrawOn(Canvas& canvas) const
{
  const std::array<int, 2> corner = Of.layout ? Of.layout->corner : std::array<int, 2>{};
  canvas.MoveOrigin(corner[0], corner[1]);
  canvas.Place(Options.shot.colors.Flatten(Pixels));
  Over.Draw(canvas, Pixels.width, Pixels.height);
  if (found_.dots)
  {
    canvas.Clip(Pixels.width, Pixels.height);
    FieldDots::Draw(canvas, *found_.dots, Pixels.height);
    canvas.Unclip();
  }
  if (found_.arrows)
  {
    canvas.Clip(Pixels.width, Pixels.height);
    Options.arrows.Draw(canvas, *found_.arrows);
    canvas.Unclip();
  }
  if (Of.layout && Options.marks.IsAsked())
  {
    ExtremeMarks::Draw(canvas, Of, Pixels, Extremes, Of.layout->font);
  }
  canvas.MoveOrigin(-corner[0], -corner[1]);
  if (Of.layout)
  {
    DrawFigure(canvas);
  }
}

void DrawnShot::DrawFigure(Canvas& canvas) const
{
  FigureContent content{ Of, *Colors, Pixels, Options.shot.colors, true, {}, {}, {} };
  content.hasBars = !Told.IsInPlace() && (!Options.contours.Only() || Options.contours.ByMap());
  for (const ColorMeaning& meaning : Told.SeenLegend(Pixels))
  {
    content.marks.push_back({ meaning.color, std::string(meaning.meaning) });
  }
  if (Told.LargestJump() > 0.0)
  {
    content.bar = FigureBar{ "jump of " + Of.scene.layers.front().field->name,
      { 0.0, Told.LargestJump() }, JumpColors(Told.LargestJump()).Map() };
  }
  AddSolidLayers(content);
  if (Told.UndecidedPixels() > 0)
  {
    content.marks.push_back({ *Colors->GetView().appearance.undecided, "undecided" });
  }
  AddNoLogarithm(content);
  if (found_.arrows)
  {
    content.arrow = { found_.arrows->longest, found_.arrows->pixelsPerValue, found_.arrows->field,
      [this, &canvas](const CanvasPoint& from, const CanvasPoint& to)
      { Options.arrows.DrawOne(canvas, from, to); } };
  }
  Options.figure.Draw(canvas, content);
}

void DrawnShot::AddSolidLayers(FigureContent& content) const
{
  if (Told.IsInPlace())
  {
    return;
  }
  const std::size_t layers = Of.scene.layers.size();
  const std::size_t walls = Options.shot.surfaces.CountWalls();
  for (std::size_t k = layers - std::min(walls, layers); k < layers; ++k)
  {
    if (const auto& color = Of.settings[k].color;
        color && std::ranges::find(Pixels.centres.layer, k) != Pixels.centres.layer.end())
    {
      content.marks.push_back({ ToRgba(color->data()), "jump at a face" });
    }
  }
  if (const auto& edges = Of.appearance.edges; edges && Options.shot.edgesByKind)
  {
    for (std::size_t kind = 0; kind < kFaceKinds.size(); ++kind)
    {
      content.marks.push_back({ edges->colors[kind], kFaceKinds[kind] });
    }
  }
}

void DrawnShot::AddNoLogarithm(FigureContent& content) const
{
  const auto shown = std::ranges::find_if(
    Colors->Ranges(), [](const ValueRange& range) { return range.has_value(); });
  if (shown == Colors->Ranges().end() || !content.hasBars || found_.beyond.noLogarithm == 0)
  {
    return;
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  Rgba color{};
  Colors->Maps()[static_cast<std::size_t>(shown - Colors->Ranges().begin())](
    { &none, 1 }, color.data());
  color[3] = 255;
  content.marks.push_back({ color, "no logarithm" });
}

ImageSize DrawnShot::Size() const
{
  return Of.layout ? Of.layout->size : Options.shot.size;
}

Image DrawnShot::Picture() const
{
  const ColorOptions& colors = Options.shot.colors;
  if (!Of.layout && !found_.arrows && !found_.dots)
  {
    return colors.Flatten(Pixels);
  }
  const ImageSize size = Size();
  RasterCanvas canvas(size.width, size.height, colors.BackgroundColor(),
    Of.layout ? Of.layout->font : kNoLetters, Options.font.Choice());
  DrawOn(canvas);
  return canvas.Picture();
}

std::string DrawnShot::Vectors(
  PictureFormat format, const PictureTexts& texts, const std::string& file) const
{
  const ImageSize size = Size();
  VectorCanvas canvas(format, size.width, size.height, Options.Dpi().value_or(kDefaultDpi),
    Options.shot.colors.BackgroundColor(), Of.layout ? Of.layout->font : kNoLetters,
    Options.font.Choice());
  DrawOn(canvas);
  return canvas.Finish(texts, file);
}

std::string DrawnShot::PixelsText() const
{
  const FrameCounters& pixels = Pixels.counters;
  return fmt::format(
    "{} exact, {} nothing, {} unknown", pixels.exact, pixels.nothing, pixels.unknown);
}
} // namespace pixelexact
