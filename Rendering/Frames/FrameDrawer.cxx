// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/FrameDrawer.h"

#include "Frames/GhostPixels.h"
#include "Frames/SelectionImage.h"
#include "Frames/ViewRequest.h"
#include "HighOrderModel.h"
#include "Views/VtkLook.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

#include <array>
#include <limits>
#include <utility>

namespace pixelexact
{
namespace
{
DepthOffset OffsetOf(vtkMapper* mapper)
{
  DepthOffset offset;
  switch (vtkMapper::GetResolveCoincidentTopology())
  {
    case VTK_RESOLVE_POLYGON_OFFSET:
      mapper->GetCoincidentTopologyPolygonOffsetParameters(offset.factor, offset.units);
      break;
    case VTK_RESOLVE_SHIFT_ZBUFFER:
      // Approximates the shift by an offset, as VTK's own mappers do.
      offset.factor = 4.0 * vtkMapper::GetResolveCoincidentTopologyZShift();
      break;
    default:
      break;
  }
  return offset;
}
} // namespace

ViewFrame& FrameDrawer::Begin(
  View& view, RenderWork& work, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  ViewFrame& kept = Views.Of(renderer, actor);
  const std::array<int, 4> viewport = FrameCompositor::Viewport(renderer);
  try
  {
    Complete({ .renderer = renderer,
               .mapper = mapper,
               .dataToWorld = actor->GetMatrix(),
               .opacity = actor->GetProperty()->GetOpacity(),
               .width = viewport[2],
               .height = viewport[3] },
      view);
  }
  catch (...)
  {
    kept.DropFrame();
    throw;
  }
  kept.model = Model.Last();
  kept.hasGhosts = HasGhosts;
  if (HasGhosts)
  {
    work.buffers = work.buffers | Buffer::Element;
  }
  return kept;
}

void FrameDrawer::Draw(View view, RenderWork work, FramePart part, vtkRenderer* renderer,
  vtkActor* actor, vtkMapper* mapper, const Progress& progress)
{
  ViewFrame& kept = Begin(view, work, renderer, actor, mapper);
  if (work.refine && !kept.MayBeCoarse(renderer->GetActiveCamera()))
  {
    work.seconds = std::numeric_limits<double>::infinity();
  }
  const Frame* frame = &kept.frames.Render(view, work, progress);
  kept.MakeDrawn(DepthRowsOf(renderer, actor->GetMatrix()));
  const auto draw = [&](const ViewFrame::Drawn& drawn, int sheet)
  {
    kept.compositor.Draw(renderer, actor, mapper,
      { .rgba = drawn.rgba.empty() ? frame->Image() : drawn.rgba,
        .depths = drawn.depths,
        .sheet = sheet,
        .width = frame->width,
        .height = frame->height,
        .step = kept.frames.LastStep(),
        .opacity = actor->GetProperty()->GetOpacity(),
        .offset = OffsetOf(mapper),
        .colorsVersion = kept.drawnVersion,
        .depthsVersion = kept.depthsVersion });
  };
  if (part != FramePart::Translucent || kept.seenThrough.empty())
  {
    draw(kept.opaque, 0);
  }
  if (part != FramePart::Opaque)
  {
    // Sheets are drawn from back to front.
    for (std::size_t k = kept.seenThrough.size(); k > 0; --k)
    {
      draw(kept.seenThrough[k - 1], static_cast<int>(k));
    }
  }
}

void FrameDrawer::Select(View view, RenderWork work, vtkRenderer* renderer, vtkActor* actor,
  vtkMapper* mapper, const Progress& progress)
{
  if (!renderer->GetSelector()->GetActorPassOnly())
  {
    work.buffers = work.buffers | Buffer::Element;
  }
  ViewFrame& kept = Begin(view, work, renderer, actor, mapper);
  const Frame& frame = kept.frames.Render(view, work, progress);
  const HighOrderModel& model = *kept.model;
  const SelectionPass pass = PassOf(renderer->GetSelector(), model);
  if (pass.shows == SelectionPass::Shows::Nothing)
  {
    return;
  }
  SelectionImage image = MakeSelectionImage(
    pass, frame, DepthRowsOf(renderer, actor->GetMatrix()), model.SelectedCells(), model.Blocks());
  if (HasGhosts)
  {
    HideGhosts(frame.centres, model, image.depths);
  }
  ++kept.selected;
  kept.selection.Draw(renderer, actor, mapper,
    { .rgba = image.rgba,
      .depths = image.depths,
      .width = frame.width,
      .height = frame.height,
      .offset = OffsetOf(mapper),
      .colorsVersion = kept.selected,
      .depthsVersion = kept.selected });
}

const std::shared_ptr<HighOrderModel>& FrameDrawer::ModelOf(vtkDataObject* grid)
{
  try
  {
    const std::int64_t builds = Model.Builds();
    const std::shared_ptr<HighOrderModel>& model = Model.Of(grid);
    if (Model.Builds() != builds)
    {
      HasGhosts = pixelexact::HasGhosts(*model);
      ranges_ = std::make_shared<FieldRanges>();
    }
    Views.DropOthers(model.get());
    surfaces_.DropOthers(model);
    return model;
  }
  catch (...)
  {
    Views.DropOthers(nullptr);
    surfaces_.DropOthers(nullptr);
    throw;
  }
}

void FrameDrawer::DropFrame(vtkRenderer* renderer, vtkActor* actor)
{
  Views.Of(renderer, actor).DropFrame();
}
} // namespace pixelexact
