// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/ViewRequest.h"

#include "Frames/ContourLabels.h"
#include "Views/VtkCamera.h"
#include "Views/VtkLook.h"

#include "Core/Location/Locator.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace pixelexact
{
namespace
{
// The half-space z >= -w behind the near plane.
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

/// Resets settings that are not drawn, so that views which differ only in them are equal.
void LeaveOutUnused(Appearance& appearance)
{
  if (!appearance.IsLit())
  {
    appearance.lights.clear();
    appearance.lit = {};
  }
  if (!appearance.HasContours())
  {
    appearance.contours = {};
  }
}
/// VTK's own number of dots per inch, at which a width of 1 is a pixel.
constexpr double kDots = 72.0;

double Scaled(double width, double by, double widest)
{
  return width > widest ? width : std::min(by * width, widest);
}

/// Scales lines and labels as VTK scales its own letters: by the window's dots per inch, and by the
/// number of tiles along a side of an enlarged picture.
void ScaleToDots(vtkRenderer* renderer, Appearance& appearance)
{
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  const double by = window != nullptr ? window->GetTileScale()[0] * window->GetDPI() / kDots : 1.0;
  if (by == 1.0)
  {
    return;
  }
  if (appearance.edges)
  {
    appearance.edges->width = Scaled(appearance.edges->width, by, EdgeStyle::kWidest);
  }
  ContourAppearance& contours = appearance.contours;
  contours.style.width = Scaled(contours.style.width, by, ContourStyle::kWidest);
  if (contours.labels)
  {
    const double height = Scaled(*contours.labels, by, LabelFont::kLargest);
    contours.labels = std::max(static_cast<int>(std::lround(height)), +LabelFont::kSmallest);
  }
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

void Complete(const DataView& seen, View& view)
{
  vtkRenderer* renderer = seen.renderer;
  view.camera = SetupOf(renderer->GetActiveCamera(), seen.width, seen.height,
    renderer->GetTiledAspectRatio(), seen.dataToWorld);
  view.appearance.lights = LightsOf(renderer);
  view.appearance.lit = LitViewOf(renderer->GetActiveCamera(), seen.dataToWorld);
  view.appearance.bySheets = true;
  view.scene.kept = ClippingPlanesOf(seen.mapper, seen.dataToWorld);
  // The part of the data before the near plane is cut away. VTK places that plane before all
  // visible data, so this applies only if users move it into the data, and to cameras inside the
  // data. In all other cases rays depend on the view alone.
  const KeptHalfSpace beyondNear = BeyondNear(DepthRowsOf(renderer, seen.dataToWorld));
  if (CutsInto(beyondNear, view.scene.locator->Bounds()))
  {
    view.scene.kept.push_back(beyondNear);
  }
  SetTranslucency(view, seen.opacity < 1.0);
  ScaleToDots(renderer, view.appearance);
  LeaveOutUnused(view.appearance);
}

void Complete(const CameraSight& seen, View& view)
{
  vtkMatrix4x4* const dataToWorld = seen.actor->GetMatrix();
  view.camera = SetupOf(seen.camera, seen.width, seen.height, 0.0, dataToWorld);
  view.appearance.lights = { Light{ .headlight = true } };
  view.appearance.lit = LitViewOf(seen.camera, dataToWorld);
  view.scene.kept = ClippingPlanesOf(seen.mapper, dataToWorld);
  view.stride = seen.stride;
  // The opacity is applied here, because no compositor applies it later.
  for (LayerAppearance& layer : view.appearance.layers)
  {
    layer.opacity *= seen.actor->GetProperty()->GetOpacity();
  }
  SetTranslucency(view);
  LeaveOutUnused(view.appearance);
}

void CompleteAlong(
  const CameraSetup& ray, double opacity, std::vector<KeptHalfSpace> kept, View& view)
{
  view.camera = ray;
  view.scene.kept = std::move(kept);
  SetTranslucency(view, opacity < 1.0);
  LeaveOutUnused(view.appearance);
}
} // namespace pixelexact
