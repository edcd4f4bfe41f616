// SPDX-License-Identifier: BSD-3-Clause
#include "FrameSource.h"

#include "HighOrderModel.h"
#include "VtkColorMap.h"

#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"
#include "Trace/StridedFrame.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/TileVisit.h"
#include "Trace/Tracer.h"

#include "vtkScalarsToColors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
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

vtkScalarsToColors* TableOf(const LayerRequest& layer)
{
  const bool byTable = !layer.contours.values.empty() && layer.contours.colors.empty();
  return layer.table == nullptr && byTable ? layer.contourTable : layer.table;
}

const Field* FieldOf(const LayerRequest& layer, const HighOrderModel& model)
{
  const bool none = layer.table == nullptr && layer.field == FieldChoice{};
  return none && model.Fields().empty() ? nullptr : &layer.field.In(model);
}

int ComponentOf(const LayerRequest& layer, const Field& field)
{
  const bool solid = layer.table == nullptr && !layer.contours.values.empty();
  const int component = layer.component.value_or(
    ComponentOf(solid ? layer.contourTable : layer.table, field.values.components));
  RequireComponent(field, component);
  return component;
}

FrameSource::FrameSource(FrameSourceCounters& counters)
  : TheCounters(counters)
{
}

FrameSource::~FrameSource() = default;

void FrameSource::Forget()
{
  TheFrame.reset();
  Spare = {};
  Passes.reset();
  Traced.reset();
  Colored.reset();
}

void FrameSource::DropFrame()
{
  Forget();
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

FrameSource::TraceKey FrameSource::TraceKeyOf(const FrameRequest& request) const
{
  TraceKey key{ {}, request.kept, request.camera, request.stride };
  for (const LayerRequest& layer : request.layers)
  {
    const Field* const field = FieldOf(layer, *TheModel);
    const int component = field != nullptr ? ComponentOf(layer, *field) : 0;
    if (layer.table != nullptr)
    {
      // Before that it does not know whether its colours are opaque.
      layer.table->Build();
    }
    // Nothing is behind a plane that is alone.
    const bool alone =
      request.layers.size() == 1 && dynamic_cast<const Plane*>(layer.surface.get()) != nullptr;
    const bool seenThrough = !alone &&
      (request.translucent || layer.opacity < 1.0 ||
        (layer.table != nullptr && layer.table->IsOpaque() == 0));
    key.layers.push_back({ layer.surface, layer.field, component, layer.precision, seenThrough });
  }
  return key;
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

FrameSource::ColorKey FrameSource::ColorKeyOf(const FrameRequest& request) const
{
  ColorKey key;
  key.unknown = request.unknownColor;
  bool anyLit = false;
  for (std::size_t k = 0; k < request.layers.size(); ++k)
  {
    const LayerRequest& layer = request.layers[k];
    const bool lit =
      layer.material && (layer.litWhereFlat || !TheScene.layers[k].surface->IsFlat());
    anyLit = anyLit || lit;
    vtkScalarsToColors* const table = TableOf(layer);
    std::uint64_t state = 0;
    if (table != nullptr)
    {
      state = table->GetMTime();
    }
    key.layers.push_back({ table, state, layer.table == nullptr, layer.solidColor, layer.opacity,
      lit ? layer.material : std::nullopt, layer.contours });
  }
  if (anyLit)
  {
    key.lights = request.lights;
    key.lit = request.lit;
  }
  key.edges = request.edges;
  if (std::ranges::any_of(
        request.layers, [](const LayerRequest& layer) { return !layer.contours.values.empty(); }))
  {
    key.contours = request.contours;
  }
  return key;
}

void FrameSource::MakeColors(const ColorKey& key)
{
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
  bool aborted = false;
  const Progress watched = [&](double done)
  {
    aborted = aborted || (progress && !progress(done));
    return !aborted;
  };
  if (std::isinf(seconds))
  {
    const bool fresh = Passes->Step() == 0 && Passes->PartDone() == 0.0;
    if (Passes->Complete(watched) && fresh)
    {
      Cost.Learn(Pixels(), 1, 1.0, Passes->Seconds());
    }
  }
  else
  {
    TraceInTime(seconds, watched, aborted);
  }
  Complete = Passes->IsComplete();
  if (Complete)
  {
    if (TheFrame)
    {
      Spare = std::move(*TheFrame);
    }
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

double FrameSource::Pixels() const
{
  return static_cast<double>(Traced->camera.width) * static_cast<double>(Traced->camera.height);
}

void FrameSource::TraceInTime(double seconds, const Progress& progress, const bool& aborted)
{
  using Seconds = std::chrono::duration<double>;
  const Deadline end = std::chrono::steady_clock::now() +
    std::chrono::duration_cast<Deadline::duration>(Seconds(seconds));
  if (Passes->Step() == 0 && Passes->PartDone() == 0.0)
  {
    Passes->GoTo(Cost.First(Pixels(), seconds));
  }
  bool goesOn = true;
  while (goesOn && !Passes->IsComplete())
  {
    const int step = Passes->NextStep();
    const bool tracing = Passes->Step() != 1;
    const double partBefore = Passes->PartDone();
    const double before = Passes->Seconds();
    const bool done = Passes->Refine(progress, end);
    const double part = (Passes->Step() == step ? 1.0 : Passes->PartDone()) - partBefore;
    if (tracing && part > 0.0)
    {
      Cost.Learn(Pixels(), step, part, Passes->Seconds() - before);
    }
    goesOn = done && !aborted && std::chrono::steady_clock::now() < end;
  }
  // A picture with holes is none.
  Passes->Fill();
}

void FrameSource::TraceBlocks(Buffer buffers, const Progress& progress)
{
  const Pipeline pipeline = ThePipeline();
  if (pipeline.Needs().corners != Buffer::None || Contours.Found() != nullptr || Edges)
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
  const ColorKey colors = ColorKeyOf(request);
  const bool sameColors = Colored == colors;
  if (!sameColors)
  {
    MakeColors(colors);
  }
  const Buffer wanted =
    kDrawn | request.buffers | ThePipeline().Needs().centres | Contours.NeedsOfLabels();
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
      const Pipeline pipeline = ThePipeline();
      const Camera camera = Traced->camera.Make();
      (void)KeepCorners(TheScene, camera, pipeline.Needs().corners, *TheFrame);
      Repaint(TheScene, camera, pipeline, *TheFrame);
      Contours.Finish(*TheFrame, camera);
    }
    else
    {
      ShowPreview();
    }
    Count(false);
  }
}

SampleBuffers FrameSource::Sample(
  const FrameRequest& request, std::span<const ImagePosition> positions)
{
  DropFrame();
  TheModel = request.model;
  Traced = TraceKeyOf(request);
  MakeScene(request);
  MakeColors(ColorKeyOf(request));
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
