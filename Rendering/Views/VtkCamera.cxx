// SPDX-License-Identifier: BSD-3-Clause
#include "Views/VtkCamera.h"

#include "Core/Base/Error.h"
#include "Core/Math/Mat.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

bool IsIdentity(vtkMatrix4x4* matrix)
{
  return matrix == nullptr || matrix->IsIdentity();
}

// The parallel scale is half the width; the oldest supported VTK lacks this setting.
template <typename VtkCamera>
bool HasHorizontalParallelScale(VtkCamera* camera)
{
  if constexpr (requires { camera->GetUseHorizontalParallelScale(); })
  {
    return camera->GetParallelProjection() && camera->GetUseHorizontalParallelScale();
  }
  else
  {
    return false;
  }
}

Mat3 LinearPart(vtkMatrix4x4* matrix)
{
  Mat3 linear;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      linear[column][row] = matrix->GetElement(row, column);
    }
  }
  return linear;
}

// The scale of a matrix that is a rotation times a scale; 0 for other matrices.
double ScaleOfSimilarity(vtkMatrix4x4* matrix)
{
  const bool affine = matrix->GetElement(3, 0) == 0.0 && matrix->GetElement(3, 1) == 0.0 &&
    matrix->GetElement(3, 2) == 0.0 && matrix->GetElement(3, 3) == 1.0;
  const Mat3 linear = LinearPart(matrix);
  // No view describes a mirror image.
  if (!affine || !(glm::determinant(linear) > 0.0))
  {
    return 0.0;
  }
  const double square = glm::dot(linear[0], linear[0]);
  // A product of several rotations has an error of some roundings.
  const double tolerance = 1e-13 * square;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      const double expected = i == j ? square : 0.0;
      if (!(std::abs(glm::dot(linear[i], linear[j]) - expected) <= tolerance))
      {
        return 0.0;
      }
    }
  }
  return std::sqrt(square);
}

CameraView ToDataSpace(const CameraView& view, vtkMatrix4x4* worldToData, double dataToWorldScale)
{
  const Mat3 linear = LinearPart(worldToData);
  const Vec3 translation(
    worldToData->GetElement(0, 3), worldToData->GetElement(1, 3), worldToData->GetElement(2, 3));
  CameraView moved = view;
  moved.position = linear * view.position + translation;
  moved.focalPoint = linear * view.focalPoint + translation;
  moved.viewUp = linear * view.viewUp;
  moved.parallelScale = view.parallelScale / dataToWorldScale;
  return moved;
}

// The matrix from normalised device coordinates to data space.
std::array<double, 16> InverseComposite(vtkCamera* camera, double aspect, vtkMatrix4x4* dataToWorld)
{
  vtkNew<vtkMatrix4x4> composite;
  composite->DeepCopy(WorldToDevice(camera, aspect).data());
  if (dataToWorld != nullptr)
  {
    vtkMatrix4x4::Multiply4x4(composite, dataToWorld, composite);
  }
  composite->Invert();
  std::array<double, 16> elements;
  std::copy_n(composite->GetData(), 16, elements.begin());
  return elements;
}
} // namespace

bool IsPlain(vtkCamera* camera)
{
  const double* shear = camera->GetViewShear();
  return camera->GetUserTransform() == nullptr && camera->GetUserViewTransform() == nullptr &&
    !camera->GetUseExplicitProjectionTransformMatrix() && !camera->GetUseExplicitAspectRatio() &&
    !camera->GetUseOffAxisProjection() && !HasHorizontalParallelScale(camera) &&
    !camera->GetStereo() && shear[0] == 0.0 && shear[1] == 0.0 &&
    IsIdentity(camera->GetModelTransformMatrix());
}

std::array<double, 16> WorldToDevice(vtkCamera* camera, double aspect)
{
  std::array<double, 16> matrix{};
  vtkMatrix4x4::Multiply4x4(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0)->GetData(),
    camera->GetModelViewTransformMatrix()->GetData(), matrix.data());
  return matrix;
}

CameraView ViewOf(vtkCamera* camera)
{
  CameraView view;
  camera->GetPosition(view.position.x, view.position.y, view.position.z);
  camera->GetFocalPoint(view.focalPoint.x, view.focalPoint.y, view.focalPoint.z);
  camera->GetViewUp(view.viewUp.x, view.viewUp.y, view.viewUp.z);
  view.parallel = camera->GetParallelProjection() != 0;
  view.viewAngle = camera->GetViewAngle();
  view.horizontalViewAngle = camera->GetUseHorizontalViewAngle() != 0;
  view.parallelScale = camera->GetParallelScale();
  camera->GetWindowCenter(view.windowCenter.data());
  return view;
}

void ApplyView(const CameraView& view, vtkCamera* camera)
{
  camera->SetPosition(view.position.x, view.position.y, view.position.z);
  camera->SetFocalPoint(view.focalPoint.x, view.focalPoint.y, view.focalPoint.z);
  camera->SetViewUp(view.viewUp.x, view.viewUp.y, view.viewUp.z);
  camera->SetParallelProjection(view.parallel);
  camera->SetViewAngle(view.viewAngle);
  camera->SetUseHorizontalViewAngle(view.horizontalViewAngle);
  camera->SetParallelScale(view.parallelScale);
  camera->SetWindowCenter(view.windowCenter[0], view.windowCenter[1]);
}

CameraView AsHeld(const CameraView& view)
{
  vtkNew<vtkCamera> camera;
  ApplyView(view, camera);
  CameraView held = ViewOf(camera);
  // A vtkCamera moves a focal point that is nearer than 1e-20.
  held.position = view.position;
  held.focalPoint = view.focalPoint;
  return held;
}

CameraSetup SetupOf(
  vtkCamera* camera, int width, int height, double aspect, vtkMatrix4x4* dataToWorld)
{
  CameraSetup setup;
  setup.width = width;
  setup.height = height;
  const double pixelAspect = static_cast<double>(width) / height;
  if (!(aspect > 0.0))
  {
    aspect = pixelAspect;
  }
  const bool moved = !IsIdentity(dataToWorld);
  if (moved && !(std::abs(dataToWorld->Determinant()) > 0.0))
  {
    throw Error("the actor's matrix has no inverse: give it a scale that is not zero");
  }
  // Derived renderers may stretch their pixels.
  const bool squarePixels = std::abs(aspect - pixelAspect) <= 1e-12 * pixelAspect;
  const double scale = moved ? ScaleOfSimilarity(dataToWorld) : 1.0;
  if (!IsPlain(camera) || !squarePixels || scale == 0.0)
  {
    setup.rays = InverseComposite(camera, aspect, dataToWorld);
    return setup;
  }
  const CameraView view = ViewOf(camera);
  if (!moved)
  {
    setup.rays = view;
    return setup;
  }
  vtkNew<vtkMatrix4x4> worldToData;
  vtkMatrix4x4::Invert(dataToWorld, worldToData);
  setup.rays = ToDataSpace(view, worldToData, scale);
  return setup;
}

CameraView ViewOfBox(const Box3& box, const Vec3& towardsViewer, int width, int height,
  const Vec3& viewUp, bool parallel, double viewAngle)
{
  const double length = glm::length(towardsViewer);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    throw Error("the direction to look along is zero or not finite");
  }
  const Vec3 diagonal = box.upper - box.lower;
  if (!(diagonal.x >= 0.0 && diagonal.y >= 0.0 && diagonal.z >= 0.0))
  {
    throw Error("there is nothing to look at: the bounds are empty");
  }
  if (width < 1 || height < 1)
  {
    throw Error("an image needs at least one pixel");
  }
  const Vec3 normal = towardsViewer / length;

  CameraView view;
  view.parallel = parallel;
  view.viewAngle = viewAngle;
  view.viewUp = viewUp;
  if (std::abs(glm::dot(viewUp, normal)) > 0.999 * glm::length(viewUp))
  {
    view.viewUp = Vec3(-viewUp.z, viewUp.x, viewUp.y);
  }
  double radius = 0.5 * glm::length(diagonal);
  radius = radius > 0.0 ? radius : 0.5;
  view.parallelScale = radius;
  double angle = viewAngle * kRadiansPerDegree;
  const double aspect = static_cast<double>(width) / height;
  if (aspect < 1.0)
  {
    angle = 2.0 * std::atan(std::tan(0.5 * angle) * aspect);
    view.parallelScale = radius / aspect;
  }
  view.focalPoint = 0.5 * (box.lower + box.upper);
  view.position = view.focalPoint + radius / std::sin(0.5 * angle) * normal;
  return AsHeld(view);
}
} // namespace pixelexact
