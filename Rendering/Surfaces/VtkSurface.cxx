// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/VtkSurface.h"

#include "Surfaces/VtkFunctions.h"

#include "Core/Base/Error.h"
#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"
#include "vtkImplicitTorus.h"

#include "vtkAbstractTransform.h"
#include "vtkBox.h"
#include "vtkCone.h"
#include "vtkCylinder.h"
#include "vtkDataArray.h"
#include "vtkHomogeneousTransform.h"
#include "vtkImplicitBoolean.h"
#include "vtkImplicitFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkQuadric.h"
#include "vtkSphere.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pixelexact
{
namespace
{
constexpr const char* kAvailable = "available: vtkPlane, vtkSphere, vtkCylinder, vtkCone, "
                                   "vtkQuadric, vtkBox, vtkPlanes, vtkImplicitTorus, and "
                                   "vtkImplicitBoolean of these";

// The matrix from world space to the function's space; identity without a transform.
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
  // Evaluates the function instead of calling GetNormal(), because newer planes also have an offset
  // along the normal.
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
  // p(x) = (normal, -normal . origin) . (x, 1) becomes p(A x): a row vector times A. The row's
  // fourth number would lose digits far from the world's origin, so a point of the plane is
  // transformed instead.
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
// The function's transform, which must be affine for all functions except planes.
AffineMap AffineMapOf(vtkImplicitFunction* function)
{
  vtkNew<vtkMatrix4x4> matrix;
  MatrixOf(function, matrix);
  if (matrix->GetElement(3, 0) != 0.0 || matrix->GetElement(3, 1) != 0.0 ||
    matrix->GetElement(3, 2) != 0.0 || matrix->GetElement(3, 3) != 1.0)
  {
    throw Unsupported(std::string("a ") + function->GetClassName() +
      " with a transform that is not affine is no cut-surface of ours; leave out the perspective");
  }
  AffineMap map;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      map.linear[column][row] = matrix->GetElement(row, column);
    }
    map.offset[row] = matrix->GetElement(row, 3);
  }
  return map;
}

std::shared_ptr<const Surface> FromSphere(vtkSphere* sphere)
{
  Vec3 centre;
  sphere->GetCenter(glm::value_ptr(centre));
  return std::make_shared<Quadric>(MakeSphere(centre, sphere->GetRadius(), AffineMapOf(sphere)));
}

std::shared_ptr<const Surface> FromCylinder(vtkCylinder* cylinder)
{
  Vec3 centre;
  Vec3 axis;
  cylinder->GetCenter(glm::value_ptr(centre));
  cylinder->GetAxis(glm::value_ptr(axis));
  return std::make_shared<Quadric>(
    MakeCylinder(centre, axis, cylinder->GetRadius(), AffineMapOf(cylinder)));
}

// Newer cones may be single cones, and store place and direction in the transform.
template <class Cone>
std::shared_ptr<const Surface> FromCone(Cone* cone)
{
  if constexpr (requires { cone->GetIsDoubleCone(); })
  {
    if (!cone->GetIsDoubleCone())
    {
      throw Unsupported("one half of a vtkCone is no cut-surface of ours; switch IsDoubleCone on "
                        "and clip the other half by a plane");
    }
  }
  return std::make_shared<Quadric>(
    MakeCone(Vec3(0.0), Vec3(1.0, 0.0, 0.0), cone->GetAngle(), AffineMapOf(cone)));
}

std::shared_ptr<const Surface> FromQuadric(vtkQuadric* quadric)
{
  std::array<double, 10> coefficients;
  quadric->GetCoefficients(coefficients.data());
  return std::make_shared<Quadric>(MakeQuadric(coefficients, AffineMapOf(quadric)));
}

std::shared_ptr<const Surface> FromBox(vtkBox* box)
{
  Vec3 lower;
  Vec3 upper;
  box->GetXMin(glm::value_ptr(lower));
  box->GetXMax(glm::value_ptr(upper));
  return std::make_shared<ConvexBody>(MakeBox(lower, upper, AffineMapOf(box)));
}

std::shared_ptr<const Surface> FromPlanes(vtkPlanes* planes)
{
  std::vector<HalfSpace> halfSpaces;
  const int count = planes->GetPoints() != nullptr && planes->GetNormals() != nullptr
    ? planes->GetNumberOfPlanes()
    : 0;
  for (int i = 0; i < count; ++i)
  {
    HalfSpace half;
    planes->GetPoints()->GetPoint(i, glm::value_ptr(half.point));
    planes->GetNormals()->GetTuple(i, glm::value_ptr(half.normal));
    halfSpaces.push_back(half);
  }
  return std::make_shared<ConvexBody>(halfSpaces, AffineMapOf(planes), "vtkPlanes");
}

std::shared_ptr<const Surface> FromTorus(vtkImplicitTorus* torus)
{
  if (!AffineMapOf(torus).IsIdentity())
  {
    throw Unsupported("a vtkImplicitTorus with a transform is no cut-surface of ours; give it its "
                      "centre and axis");
  }
  Vec3 centre;
  Vec3 axis;
  torus->GetCenter(glm::value_ptr(centre));
  torus->GetAxis(glm::value_ptr(axis));
  return std::make_shared<Torus>(centre, axis, torus->GetRadius(), torus->GetTubeRadius());
}

// Converts a function of class T. Classes derived from T are excluded, because they may be other
// functions.
template <class T>
bool Try(std::initializer_list<std::string_view> names, vtkImplicitFunction* function,
  std::shared_ptr<const Surface> (*from)(T*), std::shared_ptr<const Surface>& surface)
{
  T* const known = T::SafeDownCast(function);
  if (known == nullptr || std::ranges::find(names, function->GetClassName()) == names.end())
  {
    return false;
  }
  surface = from(known);
  return true;
}

std::shared_ptr<const Surface> ToClosedForm(vtkImplicitFunction* function)
{
  std::shared_ptr<const Surface> surface;
  // The first matching class converts it. ParaView's classes differ from VTK's in their setters.
  (void)(Try<vtkPlane>({ "vtkPlane", "vtkPVPlane" }, function, FromPlane, surface) ||
    Try<vtkSphere>({ "vtkSphere" }, function, FromSphere, surface) ||
    Try<vtkCylinder>({ "vtkCylinder", "vtkPVCylinder" }, function, FromCylinder, surface) ||
    Try<vtkCone>({ "vtkCone" }, function, FromCone<vtkCone>, surface) ||
    Try<vtkQuadric>({ "vtkQuadric" }, function, FromQuadric, surface) ||
    Try<vtkBox>({ "vtkBox", "vtkPVBox" }, function, FromBox, surface) ||
    Try<vtkPlanes>({ "vtkPlanes" }, function, FromPlanes, surface) ||
    Try<vtkImplicitTorus>({ "vtkImplicitTorus" }, function, FromTorus, surface));
  return surface;
}
} // namespace

std::shared_ptr<const Surface> ToSurface(vtkImplicitFunction* function, const SurfaceSearch& search)
{
  if (function == nullptr)
  {
    throw Error(std::string("no cut function and no surface (") + kAvailable + ")");
  }
  std::string why =
    std::string("cannot cut with a ") + function->GetClassName() + " (" + kAvailable + ")";
  try
  {
    auto* boolean = vtkImplicitBoolean::SafeDownCast(function);
    auto surface = boolean != nullptr ? FromBoolean(boolean, ToClosedForm) : ToClosedForm(function);
    if (surface != nullptr)
    {
      return surface;
    }
  }
  catch (const Unsupported& error)
  {
    why = error.what();
  }
  if (search.box.lower.x <= search.box.upper.x)
  {
    return FromAnyFunction(function, search.box, search.samples);
  }
  throw Unsupported(why);
}
} // namespace pixelexact
