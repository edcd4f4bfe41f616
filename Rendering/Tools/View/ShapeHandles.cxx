// SPDX-License-Identifier: BSD-3-Clause
#include "View/ShapeHandles.h"

#include "Views/VtkCamera.h"

#include <glm/geometric.hpp>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
constexpr float kBall = 15.0F; ///< diameter in pixels
constexpr float kLine = 1.5F;  ///< width in pixels
constexpr double kReach = 9.0; ///< largest distance in pixels at which a pointer grabs a ball
/// Handles whose distances from the pointer differ by less, in pixels, are at the same place.
constexpr double kSamePlace = 2.0;
constexpr std::array<unsigned char, 3> kColor{ 240, 120, 20 };
constexpr std::array<unsigned char, 3> kMarkedColor{ 220, 0, 60 };

void AddTo(vtkRenderer& renderer, vtkActor& actor, vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  actor.SetMapper(mapper);
  actor.PickableOff();
  actor.GetProperty()->LightingOff();
  renderer.AddActor(&actor);
}

Ray RayAt(const CameraView& view, vtkRenderer& renderer, const std::array<int, 2>& at)
{
  const int* origin = renderer.GetOrigin();
  const int* size = renderer.GetSize();
  return Camera(view, size[0], size[1]).At(at[0] + 0.5 - origin[0], at[1] + 0.5 - origin[1]);
}

/// The point of the ray in the plane through `place` with the normal `forward`.
Vec3 AtDepthOf(const Ray& ray, const Vec3& place, const Vec3& forward)
{
  return ray.origin +
    glm::dot(place - ray.origin, forward) / glm::dot(ray.direction, forward) * ray.direction;
}
} // namespace

ShapeHandles::ShapeHandles(std::unique_ptr<DraggedShape> shape)
  : Moved(std::move(shape))
{
  Over->SetLayer(1);
  Over->InteractiveOff();
  AddTo(*Over, *SegmentActor, Segments);
  AddTo(*Over, *BallActor, Balls);
  BallActor->GetProperty()->SetPointSize(kBall);
  BallActor->GetProperty()->RenderPointsAsSpheresOn();
  BallActor->GetProperty()->LightingOn();
  SegmentActor->GetProperty()->SetLineWidth(kLine);
  SegmentActor->GetProperty()->SetColor(kColor[0] / 255.0, kColor[1] / 255.0, kColor[2] / 255.0);
}

ShapeHandles::~ShapeHandles() = default;

void ShapeHandles::TurnVisible()
{
  BallActor->SetVisibility(BallActor->GetVisibility() == 0 ? 1 : 0);
  SegmentActor->SetVisibility(BallActor->GetVisibility());
}

void ShapeHandles::Update(vtkCamera& picture)
{
  if (!Moved)
  {
    return;
  }
  View = ViewOf(&picture);
  const std::vector<Vec3> handles = Moved->Handles(View);
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (std::size_t k = 0; k < handles.size(); ++k)
  {
    const vtkIdType id = places->InsertNextPoint(handles[k].x, handles[k].y, handles[k].z);
    vertices->InsertNextCell(1, &id);
    colors->InsertNextTypedTuple(k == Marked ? kMarkedColor.data() : kColor.data());
  }
  Balls->SetPoints(places);
  Balls->SetVerts(vertices);
  Balls->GetPointData()->SetScalars(colors);
  vtkNew<vtkPoints> ends;
  vtkNew<vtkCellArray> lines;
  for (const auto& [from, to] : Moved->Lines(View))
  {
    const std::array<vtkIdType, 2> ids{ ends->InsertNextPoint(from.x, from.y, from.z),
      ends->InsertNextPoint(to.x, to.y, to.z) };
    lines->InsertNextCell(2, ids.data());
  }
  Segments->SetPoints(ends);
  Segments->SetLines(lines);
  // A camera of its own has clipping planes that contain the handles.
  ApplyView(View, Over->GetActiveCamera());
  Over->ResetCameraClippingRange();
}

std::optional<std::size_t> ShapeHandles::HandleAt(const std::array<int, 2>& at) const
{
  if (!Moved || BallActor->GetVisibility() == 0)
  {
    return std::nullopt;
  }
  const std::vector<Vec3> handles = Moved->Handles(View);
  std::optional<std::size_t> nearest;
  double least = kReach;
  for (std::size_t k = 0; k < handles.size(); ++k)
  {
    std::array<double, 3> place{ handles[k].x, handles[k].y, handles[k].z };
    Over->WorldToView(place[0], place[1], place[2]);
    Over->ViewToNormalizedViewport(place[0], place[1], place[2]);
    const int* origin = Over->GetOrigin();
    const int* size = Over->GetSize();
    const double away =
      std::hypot(place[0] * size[0] + origin[0] - at[0], place[1] * size[1] + origin[1] - at[1]);
    if (away < (nearest ? least - kSamePlace : kReach))
    {
      nearest = k;
      least = away;
    }
  }
  return nearest;
}

bool ShapeHandles::PointAt(const std::array<int, 2>& at)
{
  const std::optional<std::size_t> before = std::exchange(Marked, HandleAt(at));
  return before != Marked;
}

bool ShapeHandles::Grab(const std::array<int, 2>& at)
{
  Grabbed = HandleAt(at);
  Marked = Grabbed;
  Last = at;
  return Grabbed.has_value();
}

void ShapeHandles::DragTo(const std::array<int, 2>& at)
{
  const Vec3 handle = Moved->Handles(View)[*Grabbed];
  const Vec3 ahead = glm::normalize(View.focalPoint - View.position);
  const Vec3 forward = View.parallel ? ahead : glm::normalize(handle - View.position);
  const Vec3 from = AtDepthOf(RayAt(View, *Over, Last), handle, forward);
  const Vec3 to = AtDepthOf(RayAt(View, *Over, at), handle, forward);
  const Vec3 right = glm::normalize(glm::cross(forward, View.viewUp));
  Moved->Drag(*Grabbed, View, { to - from, forward, glm::cross(right, forward) });
  Last = at;
}
} // namespace pixelexact
