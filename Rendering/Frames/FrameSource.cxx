// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameSource.h"

#include "Frames/ContourLabels.h"
#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/StridedFrame.h"
#include "Trace/TileVisit.h"
#include "Trace/TimedPasses.h"
#include "Trace/Tracer.h"

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

void RequireNoModules(const Pipeline& pipeline)
{
  if (!pipeline.modules.empty())
  {
    throw Error(
      "a stride leaves out pixels, and contours, edges and smooth edges are of each; leave "
      "out one of them.");
  }
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
  ThePainter.reset();
}

void FrameSource::DropFrame()
{
  Forget();
  Spare = {};
  TheScene = {};
  TheModel.reset();
  Bounds.reset();
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

void FrameSource::MakePainter(const Frame* frame)
{
  ThePainter.reset();
  if (!Bounds)
  {
    Bounds = std::make_shared<ContourBounds>();
  }
  if (TheAppearance.HasContours() && TheAppearance.contours.labels)
  {
    RequireLabelSize(*TheAppearance.contours.labels);
  }
  Resolved = Resolve(TheAppearance, TheScene, frame, *Ranges);
  ThePainter = std::make_unique<Painter>(TheAppearance, TheScene, Resolved, Bounds);
}

Pipeline FrameSource::TracingPipeline()
{
  // What follows from values is not known before they are traced.
  return TheAppearance.NeedsFrame() ? Pipeline{} : ThePainter->MakePipeline();
}

void FrameSource::BeginFrame(Buffer buffers)
{
  TheBuffers = buffers;
  // Corners are kept, so that other contours trace nothing.
  const Buffer corners = ThePainter->MakePipeline().Needs().corners;
  Passes.emplace(
    TheScene, Traced->camera.Make(), TracingPipeline(), buffers, corners, std::exchange(Spare, {}));
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
    if (TheAppearance.NeedsFrame())
    {
      Paint();
    }
    else
    {
      WriteLabels();
    }
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
  if (TheAppearance.NeedsFrame())
  {
    const Frame values = Passes->Preview();
    MakePainter(&values);
    Pipeline pipeline = ThePainter->MakePipeline();
    pipeline.modules.clear();
    Passes->Recolor(std::move(pipeline));
  }
  TheFrame = Passes->Preview();
  TheStep = std::max(1, Passes->Step());
  // Of a frame that was to be made at once and was ended, others will be there the next time.
  Shown = Passes->Step() == 0 ? std::nullopt : std::optional(Passes->Step());
}

void FrameSource::WriteLabels()
{
  if (ThePainter->Labels())
  {
    DrawContourLabels(*TheFrame, Traced->camera.Make(), *ThePainter->Contours(),
      *ThePainter->Lines(), *ThePainter->Labels());
  }
}

void FrameSource::Paint()
{
  if (!Complete)
  {
    ShowPreview();
    return;
  }
  if (TheAppearance.NeedsFrame())
  {
    MakePainter(&*TheFrame);
  }
  const Pipeline pipeline = ThePainter->MakePipeline();
  const Camera camera = Traced->camera.Make();
  (void)KeepCorners(TheScene, camera, pipeline.Needs().corners, *TheFrame);
  Repaint(TheScene, camera, pipeline, *TheFrame);
  WriteLabels();
}

void FrameSource::TraceBlocks(Buffer buffers, const Progress& progress)
{
  bool aborted = false;
  TheBuffers = buffers;
  TheFrame = TraceStrided(TheScene, Traced->camera.Make(), buffers, Traced->stride,
    [&](double part)
    {
      aborted = aborted || (progress && !progress(part));
      return !aborted;
    });
  Complete = true;
  Paint();
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
  Appearance appearance = AppearanceOf(request, TheScene);
  const bool sameAppearance = ThePainter && TheAppearance == appearance;
  Ranges = request.ranges ? request.ranges : std::make_shared<FieldRanges>();
  if (!sameAppearance)
  {
    TheAppearance = std::move(appearance);
    MakePainter(nullptr);
  }
  const Buffer wanted =
    kDrawn | request.buffers | NeedsOf(TheAppearance, TheScene, TheAppearance.NeedsFrame());
  if (request.stride > 1)
  {
    RequireNoModules(ThePainter->MakePipeline());
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
  else if (!Complete && !sameAppearance)
  {
    const Pipeline pipeline = TracingPipeline();
    Passes->Recolor(pipeline, pipeline.Needs().corners);
    Shown.reset();
  }
  if (!Complete && (request.refine || !TheFrame))
  {
    TraceFrame(request.seconds, progress);
  }
  else if (!sameAppearance)
  {
    Paint();
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
  Ranges = request.ranges ? request.ranges : std::make_shared<FieldRanges>();
  TheAppearance = AppearanceOf(request, TheScene);
  MakePainter(nullptr);
  const Pipeline pipeline = ThePainter->MakePipeline();
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
