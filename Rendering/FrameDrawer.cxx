// SPDX-License-Identifier: BSD-3-Clause
#include "FrameDrawer.h"

#include "HighOrderModel.h"

#include "Core/Base/Error.h"
#include "Core/Location/Locator.h"

#include "vtkActor.h"
#include "vtkCamera.h"
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
// The projection that OpenGL's geometry takes, from data space.
DepthRows RowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld)
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

std::array<std::uint8_t, 4> ColorOf(vtkProperty* property)
{
  double rgb[3];
  property->GetColor(rgb);
  std::array<std::uint8_t, 4> color{ 0, 0, 0, 255 };
  std::transform(rgb, rgb + 3, color.begin(),
    [](double channel)
    { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(channel, 0.0, 1.0))); });
  return color;
}
} // namespace

void FrameDrawer::Complete(
  FrameRequest& request, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  vtkMatrix4x4* dataToWorld = actor->GetMatrix();
  const std::array<int, 4> viewport = FrameCompositor::Viewport(renderer);
  request.camera = SetupOf(renderer->GetActiveCamera(), viewport[2], viewport[3],
    renderer->GetTiledAspectRatio(), dataToWorld);
  request.solidColor = ColorOf(actor->GetProperty());
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
  if (CutsInto(beyondNear, TheSource.ModelOf(request.grid)->GetLocator().Bounds()))
  {
    request.kept.push_back(beyondNear);
  }
}

void FrameDrawer::Draw(FrameRequest request, vtkRenderer* renderer, vtkActor* actor,
  vtkMapper* mapper, const Progress& progress)
{
  try
  {
    Complete(request, renderer, actor, mapper);
  }
  catch (...)
  {
    TheSource.DropFrame();
    throw;
  }
  const Frame& frame = TheSource.Render(request, progress);

  const DepthRows rows = RowsOf(renderer, actor->GetMatrix());
  if (DepthsTrace != TheSource.Counters().traces || Rows != rows)
  {
    WindowDepth(frame.centres, rows, Depths);
    DepthsTrace = TheSource.Counters().traces;
    Rows = rows;
    ++DepthsVersion;
  }
  Compositor.Draw(renderer, actor, mapper,
    { .rgba = frame.color,
      .depths = Depths,
      .width = frame.width,
      .height = frame.height,
      .opacity = actor->GetProperty()->GetOpacity(),
      .colorsVersion = TheSource.Version(),
      .depthsVersion = DepthsVersion });
}
} // namespace pixelexact
