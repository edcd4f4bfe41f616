// SPDX-License-Identifier: BSD-3-Clause
#include "VtkSurface.h"

#include "Core/Base/Error.h"
#include "Trace/Plane.h"

#include "vtkAbstractTransform.h"
#include "vtkHomogeneousTransform.h"
#include "vtkImplicitFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <string>

namespace pixelexact
{
namespace
{
constexpr const char* kAvailable = "available: vtkPlane";

// The matrix that takes a point to the space in which the function is written; identity without a
// transform.
void MatrixOf(vtkImplicitFunction* function, vtkMatrix4x4* matrix)
{
  vtkAbstractTransform* transform = function->GetTransform();
  if (transform == nullptr)
  {
    return;
  }
  auto* homogeneous = vtkHomogeneousTransform::SafeDownCast(transform);
  if (homogeneous == nullptr)
  {
    throw Unsupported(std::string("a ") + function->GetClassName() + " moved by a " +
      transform->GetClassName() + " is no cut-surface of ours; use a vtkTransform");
  }
  homogeneous->Update();
  matrix->DeepCopy(homogeneous->GetMatrix());
}

std::shared_ptr<const Surface> FromPlane(vtkPlane* plane)
{
  Vec3 origin;
  Vec3 normal;
  plane->GetOrigin(glm::value_ptr(origin));
  // The function itself, and not GetNormal(): newer planes also have an offset along the normal.
  plane->EvaluateGradient(glm::value_ptr(origin), glm::value_ptr(normal));
  const double square = glm::dot(normal, normal);
  if (square == 0.0)
  {
    throw Error("the normal of the vtkPlane is zero");
  }
  origin -= plane->EvaluateFunction(glm::value_ptr(origin)) / square * normal;

  vtkNew<vtkMatrix4x4> toFunction;
  MatrixOf(plane, toFunction);
  if (toFunction->IsIdentity())
  {
    return std::make_shared<Plane>(origin, normal);
  }
  if (!(std::abs(toFunction->Determinant()) > 0.0))
  {
    throw Error("the transform of the vtkPlane has no inverse");
  }
  // p(x) = (normal, -normal . origin) . (x, 1) becomes p(A x): a row vector times A. Its fourth
  // number would cost digits far from the world's origin, so a point of the plane is moved instead.
  const double row[4] = { normal.x, normal.y, normal.z, -glm::dot(normal, origin) };
  double moved[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      moved[j] += row[i] * toFunction->GetElement(i, j);
    }
  }
  vtkNew<vtkMatrix4x4> fromFunction;
  vtkMatrix4x4::Invert(toFunction, fromFunction);
  const double point[4] = { origin.x, origin.y, origin.z, 1.0 };
  double movedPoint[4];
  fromFunction->MultiplyPoint(point, movedPoint);
  if (movedPoint[3] == 0.0)
  {
    throw Error("the transform of the vtkPlane moves its origin to infinity");
  }
  return std::make_shared<Plane>(Vec3(movedPoint[0], movedPoint[1], movedPoint[2]) / movedPoint[3],
    Vec3(moved[0], moved[1], moved[2]));
}
} // namespace

std::shared_ptr<const Surface> ToSurface(vtkImplicitFunction* function)
{
  if (function == nullptr)
  {
    throw Error(std::string("no cut function (") + kAvailable + ")");
  }
  if (auto* plane = vtkPlane::SafeDownCast(function))
  {
    return FromPlane(plane);
  }
  throw Unsupported(
    std::string("cannot cut with a ") + function->GetClassName() + " (" + kAvailable + ")");
}
} // namespace pixelexact
