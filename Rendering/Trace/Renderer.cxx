// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Renderer.h"

#include "Core/Base/Error.h"
#include "Trace/BufferTable.h"
#include "Trace/Contours/LayerBounds.h"
#include "Trace/TileVisit.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
// Windows compute depths from these buffers.
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

Renderer::Renderer(RenderCounters& counters, LabelWriter labels)
  : Counters(counters)
  , Labels(std::move(labels))
{
}

Renderer::~Renderer() = default;

void Renderer::Forget()
{
  if (Shown)
  {
    Spare = std::move(*Shown);
    Shown.reset();
  }
  Passes.reset();
  HasRays = false;
  Paints.reset();
}

void Renderer::DropFrame()
{
  Forget();
  Spare = {};
  Current = {};
  Bounds.reset();
}

void Renderer::Count(bool traced)
{
  Counters.traces += traced ? 1 : 0;
  ++Counters.colorings;
  LastVersion = Counters.traces + Counters.colorings;
  LastTraceVersion = traced ? LastVersion : LastTraceVersion;
}

void Renderer::MakePainter(const Frame* frame)
{
  Paints.reset();
  if (!Bounds)
  {
    Bounds = std::make_shared<ContourBounds>();
  }
  Resolved = Resolve(Current, frame, *Ranges);
  Paints = std::make_unique<Painter>(Current, Resolved, Bounds);
}

Pipeline Renderer::TracingPipeline()
{
  // Ranges and iso-values that depend on values are unknown before the frame is traced.
  return Current.appearance.NeedsFrame() ? Pipeline{} : Paints->MakePipeline();
}

void Renderer::BeginFrame(Buffer buffers)
{
  Buffers = buffers;
  // The frame keeps corners, so that changed contours trace nothing.
  const Buffer corners = Paints->MakePipeline().Needs().corners;
  Passes.emplace(Current.scene, Current.camera.Make(), TracingPipeline(), buffers, corners,
    std::exchange(Spare, {}));
  Previewed.reset();
  Complete = false;
}

void Renderer::TraceFrame(double seconds, const Progress& progress)
{
  TracePasses(*Passes, Cost, seconds, progress);
  Complete = Passes->IsComplete();
  if (Complete)
  {
    Shown = Passes->Take();
    Passes.reset();
    Step = 1;
    if (Current.appearance.NeedsFrame())
    {
      Paint();
    }
    else
    {
      WriteLabels();
    }
    Count(true);
  }
  else if (!Previewed || *Previewed != Passes->Step())
  {
    ShowPreview();
    Count(true);
  }
}

void Renderer::ShowPreview()
{
  if (Current.appearance.NeedsFrame())
  {
    const Frame values = Passes->Preview();
    MakePainter(&values);
    Pipeline pipeline = Paints->MakePipeline();
    pipeline.modules.clear();
    Passes->Recolor(std::move(pipeline));
  }
  Shown = Passes->Preview();
  Step = std::max(1, Passes->Step());
  // An aborted frame without passes has other tiles at the next call.
  Previewed = Passes->Step() == 0 ? std::nullopt : std::optional(Passes->Step());
}

void Renderer::WriteLabels()
{
  if (Labels && Paints->Labels())
  {
    Labels(*Shown, Current.camera.Make(), *Paints);
  }
}

void Renderer::Paint()
{
  if (!Complete)
  {
    ShowPreview();
    return;
  }
  if (Current.appearance.NeedsFrame())
  {
    MakePainter(&*Shown);
  }
  const Pipeline pipeline = Paints->MakePipeline();
  const Camera camera = Current.camera.Make();
  (void)KeepCorners(Current.scene, camera, pipeline.Needs().corners, *Shown);
  Repaint(Current.scene, camera, pipeline, *Shown);
  WriteLabels();
}

void Renderer::TraceBlocks(Buffer buffers, const Progress& progress)
{
  bool aborted = false;
  Buffers = buffers;
  Shown = TraceStrided(Current.scene, Current.camera.Make(), buffers, Current.stride,
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

const Frame& Renderer::Render(const View& view, const RenderWork& work, const Progress& progress)
{
  try
  {
    Update(view, work, progress);
  }
  catch (...)
  {
    // A failed call must not leave the frame of an earlier view.
    DropFrame();
    throw;
  }
  return *Shown;
}

void Renderer::Update(const View& view, const RenderWork& work, const Progress& progress)
{
  if (Current.data != view.data)
  {
    DropFrame();
  }
  const bool sameRays = HasRays && HaveSameRays(Current, view);
  if (!sameRays)
  {
    Forget();
  }
  const bool sameAppearance =
    Paints && Current.appearance == view.appearance && Current.volume == view.volume;
  Current = view;
  HasRays = true;
  Ranges = work.ranges ? work.ranges : std::make_shared<FieldRanges>();
  if (!sameAppearance)
  {
    MakePainter(nullptr);
  }
  const Buffer wanted = kDrawn | work.buffers | NeedsOf(view, view.appearance.NeedsFrame());
  if (view.stride > 1)
  {
    RequireNoModules(Paints->MakePipeline());
    if (!sameRays || !Complete || !Includes(Buffers, wanted))
    {
      TraceBlocks(wanted | AllBuffers(), progress);
      return;
    }
  }
  else if (!sameRays || !Includes(Buffers, wanted))
  {
    BeginFrame(wanted);
  }
  else if (!Complete && !sameAppearance)
  {
    const Pipeline pipeline = TracingPipeline();
    Passes->Recolor(pipeline, pipeline.Needs().corners);
    Previewed.reset();
  }
  if (!Complete && (work.refine || !Shown))
  {
    TraceFrame(work.seconds, progress);
  }
  else if (!sameAppearance)
  {
    Paint();
    Count(false);
  }
}

SampleBuffers Renderer::Sample(
  const View& view, std::span<const ImagePosition> positions, std::shared_ptr<FieldRanges> ranges)
{
  DropFrame();
  Current = view;
  Ranges = ranges ? std::move(ranges) : std::make_shared<FieldRanges>();
  MakePainter(nullptr);
  const Pipeline pipeline = Paints->MakePipeline();
  const Camera camera = view.camera.Make();
  Frame none;
  TileVisit visit(&Current.scene, &camera, pipeline, none, {});
  SampleBuffers samples = visit.Trace(positions, kDrawn | AllBuffers() | pipeline.Needs().centres);
  (void)visit.Image(samples); // paints the sheets
  return samples;
}

Buffer Renderer::AllBuffers() const
{
  const bool values = std::ranges::all_of(
    Current.scene.layers, [](const Layer& layer) { return layer.field != nullptr; });
  return values ? UsualBuffers() : Without(UsualBuffers(), Buffer::Value);
}

const Frame* Renderer::FrameWithAllBuffers()
{
  if (!Shown)
  {
    return nullptr;
  }
  if (!Complete || !Includes(Buffers, AllBuffers()))
  {
    BeginFrame(Buffers | AllBuffers());
    TraceFrame(std::numeric_limits<double>::infinity(), {});
  }
  return &*Shown;
}
} // namespace pixelexact
