// SPDX-License-Identifier: BSD-3-Clause
#include "FrameDrawer.h"

#include "HighOrderModel.h"
#include "SelectionImage.h"
#include "VtkLook.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace pixelexact
{
namespace
{
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

DepthRows DepthRowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld)
{
  vtkNew<vtkMatrix4x4> composite;
  composite->DeepCopy(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1.0, 1.0));
  vtkMatrix4x4::Multiply4x4(composite, dataToWorld, composite);
  DepthRows rows;
  for (int i = 0; i < 4; ++i)
  {
    rows.z[static_cast<std::size_t>(i)] = composite->GetElement(2, i);
    rows.w[static_cast<std::size_t>(i)] = composite->GetElement(3, i);
  }
  return rows;
}

std::vector<KeptHalfSpace> ClippingPlanesOf(vtkMapper* mapper, vtkMatrix4x4* dataToWorld)
{
  std::vector<KeptHalfSpace> planes(static_cast<std::size_t>(mapper->GetNumberOfClippingPlanes()));
  for (int i = 0; i < mapper->GetNumberOfClippingPlanes(); ++i)
  {
    mapper->GetClippingPlaneInDataCoords(
      dataToWorld, i, planes[static_cast<std::size_t>(i)].data());
  }
  return planes;
}

void CompleteRequest(const DataView& view, const Box3& bounds, FrameRequest& request)
{
  vtkRenderer* renderer = view.renderer;
  request.camera = SetupOf(renderer->GetActiveCamera(), view.width, view.height,
    renderer->GetTiledAspectRatio(), view.dataToWorld);
  request.lights = LightsOf(renderer);
  request.lit = LitViewOf(renderer, view.dataToWorld);
  request.translucent = view.opacity < 1.0;
  request.kept = ClippingPlanesOf(view.mapper, view.dataToWorld);
  // What lies before the near plane shows what is behind it. VTK puts that plane before all that is
  // visible, so this is for users who move it into the data, and for cameras inside of it; all
  // others get rays that depend on the view alone.
  const KeptHalfSpace beyondNear = BeyondNear(DepthRowsOf(renderer, view.dataToWorld));
  if (CutsInto(beyondNear, bounds))
  {
    request.kept.push_back(beyondNear);
  }
}

const Frame& FrameDrawer::Render(FrameRequest& request, vtkRenderer* renderer, vtkActor* actor,
  vtkMapper* mapper, const Progress& progress)
{
  try
  {
    const std::array<int, 4> viewport = FrameCompositor::Viewport(renderer);
    CompleteRequest({ .renderer = renderer,
                      .mapper = mapper,
                      .dataToWorld = actor->GetMatrix(),
                      .opacity = actor->GetProperty()->GetOpacity(),
                      .width = viewport[2],
                      .height = viewport[3] },
      TheSource.ModelOf(request.grid)->GetLocator().Bounds(), request);
  }
  catch (...)
  {
    TheSource.DropFrame();
    throw;
  }
  return TheSource.Render(request, progress);
}

void FrameDrawer::MakeDrawn(const Frame& frame, const DepthRows& rows)
{
  const FrameSourceCounters& counters = TheSource.Counters();
  const bool moved = DrawnTrace != counters.traces || Rows != rows;
  if (!moved && DrawnVersion == TheSource.Version())
  {
    return;
  }
  const std::vector<Layer>& layers = TheSource.LastScene().layers;
  const bool seenThrough = std::ranges::any_of(layers, &Layer::translucent);
  DepthsVersion += moved || seenThrough ? 1 : 0;
  Rows = rows;
  DrawnTrace = counters.traces;
  DrawnVersion = TheSource.Version();
  Opaque.rgba.clear();
  if (!seenThrough)
  {
    SeenThrough.clear();
    if (moved)
    {
      WindowDepth(frame.centres, rows, Opaque.depths);
    }
    return;
  }
  // Each ray ends at an opaque layer, if it meets one: at most one of its samples is of that part.
  const std::size_t pixels = frame.centres.Size();
  Opaque.rgba.assign(4 * pixels, 0);
  Opaque.depths.assign(pixels, kNoDepth);
  SeenThrough.resize(1 + frame.centres.behind.size());
  for (std::size_t k = 0; k < SeenThrough.size(); ++k)
  {
    const SampleBuffers& sheet = k == 0 ? frame.centres : frame.centres.behind[k - 1];
    Drawn& drawn = SeenThrough[k];
    drawn.rgba = sheet.color;
    WindowDepth(sheet, rows, drawn.depths);
    for (std::size_t i = 0; i < pixels; ++i)
    {
      const std::uint8_t layer = layers.size() > 1 ? sheet.layer[i] : std::uint8_t{ 0 };
      if (layer != kNoLayer && !layers[layer].translucent && drawn.depths[i] <= 1.0F)
      {
        std::copy_n(&drawn.rgba[4 * i], 4, &Opaque.rgba[4 * i]);
        Opaque.depths[i] = drawn.depths[i];
        drawn.depths[i] = kNoDepth;
      }
    }
  }
}

void FrameDrawer::Draw(FrameRequest request, FramePart part, vtkRenderer* renderer, vtkActor* actor,
  vtkMapper* mapper, const Progress& progress)
{
  const Frame& frame = Render(request, renderer, actor, mapper, progress);
  MakeDrawn(frame, DepthRowsOf(renderer, actor->GetMatrix()));
  const auto draw = [&](const Drawn& drawn, int sheet)
  {
    Compositor.Draw(renderer, actor, mapper,
      { .rgba = drawn.rgba.empty() ? frame.Image() : drawn.rgba,
        .depths = drawn.depths,
        .sheet = sheet,
        .width = frame.width,
        .height = frame.height,
        .opacity = actor->GetProperty()->GetOpacity(),
        .offset = OffsetOf(mapper),
        .colorsVersion = DrawnVersion,
        .depthsVersion = DepthsVersion });
  };
  if (part != FramePart::Translucent || SeenThrough.empty())
  {
    draw(Opaque, 0);
  }
  if (part != FramePart::Opaque)
  {
    // Back to front.
    for (std::size_t k = SeenThrough.size(); k > 0; --k)
    {
      draw(SeenThrough[k - 1], static_cast<int>(k));
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
  const Frame& frame = Render(request, renderer, actor, mapper, progress);
  const HighOrderModel& model = *TheSource.Model();
  const SelectionPass pass = PassOf(renderer->GetSelector(), model);
  if (pass.shows == SelectionPass::Shows::Nothing)
  {
    return;
  }
  const SelectionImage image = MakeSelectionImage(
    pass, frame, DepthRowsOf(renderer, actor->GetMatrix()), model.SourceCells(), model.Blocks());
  ++Selected;
  Selection.Draw(renderer, actor, mapper,
    { .rgba = image.rgba,
      .depths = image.depths,
      .width = frame.width,
      .height = frame.height,
      .offset = OffsetOf(mapper),
      .colorsVersion = Selected,
      .depthsVersion = Selected });
}

void FrameDrawer::ReleaseGraphicsResources(vtkWindow* window)
{
  Compositor.ReleaseGraphicsResources(window);
  Selection.ReleaseGraphicsResources(window);
}
} // namespace pixelexact
