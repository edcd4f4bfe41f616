// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameSource.h"

#include "HighOrderModel.h"
#include "Views/VtkColorMap.h"

#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"
#include "Trace/StridedFrame.h"
#include "Trace/TileVisit.h"
#include "Trace/TimedPasses.h"
#include "Trace/Tracer.h"

#include "vtkScalarsToColors.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
// Beyond what colours need: what depths are made of.
constexpr Buffer kDrawn = Buffer::Position | Buffer::Verdict;

bool Includes(Buffer set, Buffer wanted)
{
  return (set | wanted) == set;
}
} // namespace

FrameSource::FrameSource(FrameSourceCounters& counters)
  : TheCounters(counters)
{
}

FrameSource::~FrameSource() = default;

void FrameSource::Forget()
{
  if (TheFrame)
  {
    Spare = std::move(*TheFrame);
    TheFrame.reset();
  }
  Passes.reset();
  Traced.reset();
  Colored.reset();
}

void FrameSource::DropFrame()
{
  Forget();
  Spare = {};
  TheScene = {};
  TheModel.reset();
  Contours.Forget();
}

void FrameSource::Count(bool traced)
{
  TheCounters.traces += traced ? 1 : 0;
  ++TheCounters.colorings;
  TheVersion = TheCounters.traces + TheCounters.colorings;
  TheTraceVersion = traced ? TheVersion : TheTraceVersion;
}

void FrameSource::MakeScene(const FrameRequest& request)
{
  TheScene = {};
  TheScene.locator = &TheModel->GetLocator();
  TheScene.kept = request.kept;
  for (std::size_t k = 0; k < request.layers.size(); ++k)
  {
    const TracedLayer& traced = Traced->layers[k];
    TheScene.layers.push_back({ traced.surface, FieldOf(request.layers[k], *TheModel),
      traced.component, traced.precision, traced.translucent });
  }
}

LayerContours FrameSource::CountedContours(const ColoredLayer& layer, std::size_t k) const
{
  const Field* const field = TheScene.layers[k].field;
  if (field == nullptr)
  {
    throw Error("contours: the data have no field; set the number of contours to 0");
  }
  LayerContours contours = layer.contours;
  const double* range = layer.table->GetRange();
  contours.values = ContourValuesOver(contours.count, { range[0], range[1] },
    layer.table->UsingLogScale() != 0, field, ValuesSeen(*TheFrame, k));
  if (contours.colors.size() > 1)
  {
    contours.colors.resize(contours.values.size());
  }
  return contours;
}

Buffer FrameSource::NeedsOfCounts() const
{
  return Buffer::Value | Buffer::Verdict |
    (TheScene.layers.size() > 1 ? Buffer::Layer : Buffer::None);
}

void FrameSource::MakeColors(const ColorKey& key, bool counts)
{
  CountsAreOpen = false;
  std::vector<LayerColors> colors;
  std::vector<std::optional<Material>> materials;
  std::vector<LayerContours> contours;
  std::vector<ColorMap> contourMaps;
  for (const ColoredLayer& layer : key.layers)
  {
    const ColorMap map = layer.table != nullptr ? ToColorMap(layer.table) : SolidColor(layer.solid);
    colors.push_back({ layer.isSolid ? SolidColor(layer.solid) : map, key.unknown, layer.opacity,
      !layer.isSolid });
    materials.push_back(layer.material);
    contours.push_back(layer.contours);
    if (layer.contours.count > 0 && counts)
    {
      contours.back() = CountedContours(layer, contours.size() - 1);
    }
    else if (layer.contours.count > 0)
    {
      contours.back() = {};
      CountsAreOpen = true;
    }
    contourMaps.push_back(map);
  }
  const bool lit = std::ranges::any_of(
    materials, [](const std::optional<Material>& material) { return material.has_value(); });
  Contours.Make(TheScene, contours, contourMaps, key.contours);
  Colors.emplace(std::move(colors));
  Lights.reset();
  if (lit)
  {
    Lights = std::make_unique<Lighting>(std::move(materials), key.lights, key.lit);
  }
  Edges.reset();
  if (key.edges)
  {
    Edges = std::make_unique<ElementEdges>(*key.edges);
  }
  Colored = key;
}

Pipeline FrameSource::ThePipeline()
{
  Pipeline pipeline{ { &*Colors }, {} };
  if (Lights)
  {
    pipeline.colors.push_back(Lights.get());
  }
  if (Edges)
  {
    pipeline.modules.push_back(Edges.get());
  }
  Contours.AddTo(pipeline);
  return pipeline;
}

void FrameSource::BeginFrame(Buffer buffers)
{
  TheBuffers = buffers;
  const Pipeline pipeline = ThePipeline();
  // Corners are kept, so that other contours trace nothing.
  Passes.emplace(TheScene, Traced->camera.Make(), pipeline, buffers, pipeline.Needs().corners,
    std::exchange(Spare, {}));
  Shown.reset();
  Complete = false;
}

void FrameSource::TraceFrame(double seconds, const Progress& progress)
{
  TracePasses(*Passes, Cost, seconds, progress);
  Complete = Passes->IsComplete();
  if (Complete)
  {
    TheFrame = Passes->Take();
    Passes.reset();
    TheStep = 1;
    Contours.Finish(*TheFrame, Traced->camera.Make());
    Count(true);
  }
  else if (!Shown || *Shown != Passes->Step())
  {
    ShowPreview();
    Count(true);
  }
}

void FrameSource::ShowPreview()
{
  TheFrame = Passes->Preview();
  TheStep = std::max(1, Passes->Step());
  // Of a frame that was to be made at once and was ended, others will be there the next time.
  Shown = Passes->Step() == 0 ? std::nullopt : std::optional(Passes->Step());
}

void FrameSource::TraceBlocks(Buffer buffers, const Progress& progress)
{
  const Pipeline pipeline = ThePipeline();
  if (pipeline.Needs().corners != Buffer::None || Contours.Found() != nullptr || CountsAreOpen ||
    Edges)
  {
    throw Error("a stride leaves out pixels, and contours and edges are of each; leave out one of "
                "them.");
  }
  bool aborted = false;
  const Camera camera = Traced->camera.Make();
  TheBuffers = buffers;
  TheFrame = TraceStrided(TheScene, camera, buffers, Traced->stride,
    [&](double part)
    {
      aborted = aborted || (progress && !progress(part));
      return !aborted;
    });
  Repaint(TheScene, camera, pipeline, *TheFrame);
  Complete = !aborted;
  Count(true);
}

const Frame& FrameSource::Render(const FrameRequest& request, const Progress& progress)
{
  try
  {
    Update(request, progress);
  }
  catch (...)
  {
    // A frame that is not the one asked for must not look like it.
    DropFrame();
    throw;
  }
  return *TheFrame;
}

void FrameSource::Update(const FrameRequest& request, const Progress& progress)
{
  if (TheModel != request.model)
  {
    DropFrame();
    TheModel = request.model;
  }
  TraceKey key = TraceKeyOf(request);
  const bool sameScene = Traced == key;
  if (!sameScene)
  {
    Forget();
    Traced = std::move(key);
    MakeScene(request);
  }
  const ColorKey colors = ColorKeyOf(request, TheScene);
  const bool sameColors = Colored == colors;
  if (!sameColors)
  {
    MakeColors(
      colors, request.counts && TheFrame && Complete && Includes(TheBuffers, NeedsOfCounts()));
  }
  Buffer wanted =
    kDrawn | request.buffers | ThePipeline().Needs().centres | Contours.NeedsOfLabels();
  if (CountsAreOpen)
  {
    // Contours are made when the frame is there: its values are needed, and edges' ends welcome.
    wanted = wanted | NeedsOfCounts() | ContourCertifier({}, {}).Needs().welcome |
      (colors.contours.labels ? Buffer::Normal : Buffer::None);
  }
  if (request.stride > 1)
  {
    if (!sameScene || !Complete || !Includes(TheBuffers, wanted))
    {
      TraceBlocks(wanted | AllBuffers(), progress);
      return;
    }
  }
  else if (!sameScene || !Includes(TheBuffers, wanted))
  {
    BeginFrame(wanted);
  }
  else if (!Complete && !sameColors)
  {
    Passes->Recolor(ThePipeline(), ThePipeline().Needs().corners);
    Shown.reset();
  }
  if (!Complete && (request.refine || !TheFrame))
  {
    TraceFrame(request.seconds, progress);
  }
  else if (!sameColors)
  {
    if (Complete)
    {
      PaintAgain();
    }
    else
    {
      ShowPreview();
    }
    Count(false);
  }
  if (CountsAreOpen && Complete && request.counts)
  {
    MakeColors(colors, true);
    PaintAgain();
    Count(false);
  }
}

void FrameSource::PaintAgain()
{
  const Pipeline pipeline = ThePipeline();
  const Camera camera = Traced->camera.Make();
  (void)KeepCorners(TheScene, camera, pipeline.Needs().corners, *TheFrame);
  Repaint(TheScene, camera, pipeline, *TheFrame);
  Contours.Finish(*TheFrame, camera);
}

SampleBuffers FrameSource::Sample(
  const FrameRequest& request, std::span<const ImagePosition> positions)
{
  DropFrame();
  TheModel = request.model;
  Traced = TraceKeyOf(request);
  MakeScene(request);
  MakeColors(ColorKeyOf(request, TheScene), false);
  const Pipeline pipeline = ThePipeline();
  const Camera camera = request.camera.Make();
  Frame none;
  TileVisit visit(&TheScene, &camera, pipeline, none, {});
  SampleBuffers samples = visit.Trace(positions, kDrawn | AllBuffers() | pipeline.Needs().centres);
  (void)visit.Image(samples); // paints the sheets
  return samples;
}

Buffer FrameSource::AllBuffers() const
{
  const bool values =
    std::ranges::all_of(TheScene.layers, [](const Layer& layer) { return layer.field != nullptr; });
  return values ? UsualBuffers() : Without(UsualBuffers(), Buffer::Value);
}

const Frame* FrameSource::FrameWithAllBuffers()
{
  if (!TheFrame)
  {
    return nullptr;
  }
  if (!Complete || !Includes(TheBuffers, AllBuffers()))
  {
    BeginFrame(TheBuffers | AllBuffers());
    TraceFrame(std::numeric_limits<double>::infinity(), {});
  }
  return &*TheFrame;
}

const Frame* FrameSource::LastFrame() const
{
  return TheFrame ? &*TheFrame : nullptr;
}
} // namespace pixelexact
