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
      // As VTK's own mappers make do.
      offset.factor = 4.0 * vtkMapper::GetResolveCoincidentTopologyZShift();
      break;
    default:
      break;
  }
  return offset;
}
} // namespace

ViewFrame& FrameDrawer::Begin(
  FrameRequest& request, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  ViewFrame& view = Views.Of(renderer, actor);
  const std::array<int, 4> viewport = FrameCompositor::Viewport(renderer);
  try
  {
    CompleteRequest({ .renderer = renderer,
                      .mapper = mapper,
                      .dataToWorld = actor->GetMatrix(),
                      .opacity = actor->GetProperty()->GetOpacity(),
                      .width = viewport[2],
                      .height = viewport[3] },
      request);
  }
  catch (...)
  {
    view.source.DropFrame();
    throw;
  }
  view.hasGhosts = HasGhosts;
  if (HasGhosts)
  {
    request.buffers = request.buffers | Buffer::Element;
  }
  return view;
}

void FrameDrawer::Draw(FrameRequest request, FramePart part, vtkRenderer* renderer, vtkActor* actor,
  vtkMapper* mapper, const Progress& progress)
{
  ViewFrame& view = Begin(request, renderer, actor, mapper);
  if (request.refine && !view.MayBeCoarse(renderer->GetActiveCamera()))
  {
    request.seconds = std::numeric_limits<double>::infinity();
  }
  const Frame* frame = &view.source.Render(request, progress);
  view.MakeDrawn(DepthRowsOf(renderer, actor->GetMatrix()));
  const auto draw = [&](const ViewFrame::Drawn& drawn, int sheet)
  {
    view.compositor.Draw(renderer, actor, mapper,
      { .rgba = drawn.rgba.empty() ? frame->Image() : drawn.rgba,
        .depths = drawn.depths,
        .sheet = sheet,
        .width = frame->width,
        .height = frame->height,
        .step = view.source.LastStep(),
        .opacity = actor->GetProperty()->GetOpacity(),
        .offset = OffsetOf(mapper),
        .colorsVersion = view.drawnVersion,
        .depthsVersion = view.depthsVersion });
  };
  if (part != FramePart::Translucent || view.seenThrough.empty())
  {
    draw(view.opaque, 0);
  }
  if (part != FramePart::Opaque)
  {
    // Back to front.
    for (std::size_t k = view.seenThrough.size(); k > 0; --k)
    {
      draw(view.seenThrough[k - 1], static_cast<int>(k));
    }
  }
}

void FrameDrawer::Select(FrameRequest request, vtkRenderer* renderer, vtkActor* actor,
  vtkMapper* mapper, const Progress& progress)
{
  if (!renderer->GetSelector()->GetActorPassOnly())
  {
    request.buffers = request.buffers | Buffer::Element;
  }
  ViewFrame& view = Begin(request, renderer, actor, mapper);
  const Frame& frame = view.source.Render(request, progress);
  const HighOrderModel& model = *view.source.Model();
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
  ++view.selected;
  view.selection.Draw(renderer, actor, mapper,
    { .rgba = image.rgba,
      .depths = image.depths,
      .width = frame.width,
      .height = frame.height,
      .offset = OffsetOf(mapper),
      .colorsVersion = view.selected,
      .depthsVersion = view.selected });
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
      TheRanges = std::make_shared<FieldRanges>();
    }
    Views.DropOthers(model.get());
    TheSurfaces.DropOthers(model);
    return model;
  }
  catch (...)
  {
    Views.DropOthers(nullptr);
    TheSurfaces.DropOthers(nullptr);
    throw;
  }
}

void FrameDrawer::DropFrame(vtkRenderer* renderer, vtkActor* actor)
{
  Views.Of(renderer, actor).source.DropFrame();
}
} // namespace pixelexact
