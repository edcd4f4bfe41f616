// SPDX-License-Identifier: BSD-3-Clause
#include "FrameDrawer.h"

#include "HighOrderModel.h"
#include "VtkLook.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pixelexact
{
namespace
{
// The projection that OpenGL's geometry takes, from data space.
DepthRows RowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld)
{
  vtkNew<vtkMatrix4x4> composite;
  composite->DeepCopy(
    WorldToDevice(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio()).data());
  vtkMatrix4x4::Multiply4x4(composite, dataToWorld, composite);
  DepthRows rows;
  for (int i = 0; i < 4; ++i)
  {
    rows.z[static_cast<std::size_t>(i)] = composite->GetElement(2, i);
    rows.w[static_cast<std::size_t>(i)] = composite->GetElement(3, i);
  }
  return rows;
}

// What lies beyond the near plane: z >= -w.
KeptHalfSpace BeyondNear(const DepthRows& rows)
{
  KeptHalfSpace half{};
  std::transform(rows.z.begin(), rows.z.end(), rows.w.begin(), half.begin(), std::plus<double>());
  return half;
}

bool CutsInto(const KeptHalfSpace& half, const Box3& box)
{
  double least = half[3];
  for (int i = 0; i < 3; ++i)
  {
    const double factor = half[static_cast<std::size_t>(i)];
    least += std::min(factor * box.lower[i], factor * box.upper[i]);
  }
  return !(least >= 0.0);
}

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

void FrameDrawer::Complete(
  FrameRequest& request, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  vtkMatrix4x4* dataToWorld = actor->GetMatrix();
  const std::array<int, 4> viewport = FrameCompositor::Viewport(renderer);
  request.camera = SetupOf(renderer->GetActiveCamera(), viewport[2], viewport[3],
    renderer->GetTiledAspectRatio(), dataToWorld);
  request.lights = LightsOf(renderer);
  request.lit = LitViewOf(renderer, dataToWorld);
  request.translucent = actor->GetProperty()->GetOpacity() < 1.0;
  if (actor->GetProperty()->GetEdgeVisibility())
  {
    request.edges = ToRgba(actor->GetProperty()->GetEdgeColor());
  }
  for (int i = 0; i < mapper->GetNumberOfClippingPlanes(); ++i)
  {
    KeptHalfSpace plane{};
    mapper->GetClippingPlaneInDataCoords(dataToWorld, i, plane.data());
    request.kept.push_back(plane);
  }
  // What lies before the near plane shows what is behind it. VTK puts that plane before all that is
  // visible, so this is for users who move it into the data, and for cameras inside of it; all
  // others get rays that depend on the view alone.
  const KeptHalfSpace beyondNear = BeyondNear(RowsOf(renderer, dataToWorld));
  if (CutsInto(beyondNear, request.model->GetLocator().Bounds()))
  {
    request.kept.push_back(beyondNear);
  }
}

ColorRanges::Range FrameDrawer::Draw(FrameRequest request, FramePart part, vtkRenderer* renderer,
  vtkActor* actor, vtkMapper* mapper, const Progress& progress)
{
  ViewFrame& view = Views.Of(renderer, actor);
  try
  {
    Complete(request, renderer, actor, mapper);
  }
  catch (...)
  {
    view.source.DropFrame();
    throw;
  }
  if (request.refine && !view.MayBeCoarse(renderer->GetActiveCamera()))
  {
    request.seconds = std::numeric_limits<double>::infinity();
  }
  const Frame* frame = &view.source.Render(request, progress);
  ColorRanges::Range fitted;
  if (request.fitted != nullptr)
  {
    fitted = ColorRanges::OfFrame(*frame, request, request.fitted);
    if (fitted && ColorRanges::Set(request.fitted, *fitted))
    {
      request.refine = false;
      frame = &view.source.Render(request, progress);
    }
  }
  view.MakeDrawn(RowsOf(renderer, actor->GetMatrix()));
  const auto draw = [&](const ViewFrame::Drawn& drawn, int sheet)
  {
    view.compositor.Draw(renderer, actor, mapper,
      { .rgba = drawn.rgba.empty() ? frame->Image() : drawn.rgba,
        .depths = drawn.depths,
        .sheet = sheet,
        .width = frame->width,
        .height = frame->height,
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
  return fitted;
}

const std::shared_ptr<HighOrderModel>& FrameDrawer::ModelOf(vtkUnstructuredGrid* grid)
{
  try
  {
    const std::shared_ptr<HighOrderModel>& model = Model.Of(grid);
    Views.DropOthers(model.get());
    return model;
  }
  catch (...)
  {
    Views.DropOthers(nullptr);
    throw;
  }
}

void FrameDrawer::DropFrame(vtkRenderer* renderer, vtkActor* actor)
{
  Views.Of(renderer, actor).source.DropFrame();
}
} // namespace pixelexact
