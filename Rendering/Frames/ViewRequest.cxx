// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/ViewRequest.h"

#include "HighOrderModel.h"
#include "Views/VtkLook.h"

#include "Core/Location/Locator.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <functional>

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
} // namespace

DepthRows DepthRowsOf(vtkRenderer* renderer, vtkMatrix4x4* dataToWorld)
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

void CompleteRequest(const DataView& view, FrameRequest& request)
{
  vtkRenderer* renderer = view.renderer;
  request.camera = SetupOf(renderer->GetActiveCamera(), view.width, view.height,
    renderer->GetTiledAspectRatio(), view.dataToWorld);
  request.appearance.lights = LightsOf(renderer);
  request.appearance.lit = LitViewOf(renderer->GetActiveCamera(), view.dataToWorld);
  request.translucent = view.opacity < 1.0;
  request.appearance.bySheets = true;
  request.kept = ClippingPlanesOf(view.mapper, view.dataToWorld);
  // What lies before the near plane shows what is behind it. VTK puts that plane before all that is
  // visible, so this is for users who move it into the data, and for cameras inside of it; all
  // others get rays that depend on the view alone.
  const KeptHalfSpace beyondNear = BeyondNear(DepthRowsOf(renderer, view.dataToWorld));
  if (CutsInto(beyondNear, request.model->GetLocator().Bounds()))
  {
    request.kept.push_back(beyondNear);
  }
}

void CompleteRequest(const CameraSight& sight, FrameRequest& request)
{
  vtkMatrix4x4* const dataToWorld = sight.actor->GetMatrix();
  request.camera = SetupOf(sight.camera, sight.width, sight.height, 0.0, dataToWorld);
  request.appearance.lights = { Light{ .headlight = true } };
  request.appearance.lit = LitViewOf(sight.camera, dataToWorld);
  request.kept = ClippingPlanesOf(sight.mapper, dataToWorld);
  request.stride = sight.stride;
  // No compositor applies it afterwards.
  for (LayerRequest& layer : request.layers)
  {
    layer.appearance.opacity *= sight.actor->GetProperty()->GetOpacity();
  }
}
} // namespace pixelexact
