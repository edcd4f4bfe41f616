// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/VtkCutFunction.h"

#include "Core/Base/Error.h"

#include "vtkAbstractTransform.h"
#include "vtkBox.h"
#include "vtkCone.h"
#include "vtkCylinder.h"
#include "vtkHomogeneousTransform.h"
#include "vtkImplicitFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkQuadric.h"
#include "vtkSmartPointer.h"
#include "vtkSphere.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

namespace pixelexact
{
namespace
{
/// What is asked wherever a value is wanted.
class AskedFunction final : public CutFunction
{
public:
  AskedFunction(vtkImplicitFunction* function, double length)
    : Function(function)
    , Step(1e-6 * length)
  {
  }
  [[nodiscard]] double Value(const Vec3& x) const override
  {
    const double value = Function->FunctionValue(glm::value_ptr(x));
    if (std::isnan(value))
    {
      // So a function that fails is not asked a million times more.
      std::ostringstream text;
      text << "the " << Function->GetClassName() << " has no value at (" << x.x << ", " << x.y
           << ", " << x.z << "); give a function that has one in all of the mesh's box.";
      throw InvalidData(text.str());
    }
    return value;
  }
  [[nodiscard]] Vec3 Gradient(const Vec3& x) const override
  {
    Vec3 gradient;
    for (int d = 0; d < 3; ++d)
    {
      Vec3 before = x;
      Vec3 behind = x;
      before[d] -= Step;
      behind[d] += Step;
      gradient[d] = (Value(behind) - Value(before)) / (behind[d] - before[d]);
    }
    return gradient;
  }
  [[nodiscard]] bool NeedsCallingThread() const override { return true; }

private:
  vtkSmartPointer<vtkImplicitFunction> Function;
  double Step;
};

QuadricForm FormOf(vtkPlane* plane)
{
  QuadricForm form;
  plane->GetOrigin(glm::value_ptr(form.origin));
  // The function itself, and not GetNormal(): newer planes also have an offset along the normal.
  plane->EvaluateGradient(glm::value_ptr(form.origin), glm::value_ptr(form.g));
  if (form.g == Vec3(0.0))
  {
    throw InvalidData("the normal of the vtkPlane is zero; give it a direction.");
  }
  form.c = plane->EvaluateFunction(glm::value_ptr(form.origin));
  return form;
}

QuadricForm FormOf(vtkSphere* sphere)
{
  QuadricForm form;
  sphere->GetCenter(glm::value_ptr(form.origin));
  form.q = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
  form.c = -sphere->GetRadius() * sphere->GetRadius();
  return form;
}

QuadricForm FormOf(vtkCylinder* cylinder)
{
  QuadricForm form;
  Vec3 axis;
  cylinder->GetCenter(glm::value_ptr(form.origin));
  cylinder->GetAxis(glm::value_ptr(axis));
  if (axis == Vec3(0.0))
  {
    throw InvalidData("the axis of the vtkCylinder is zero; give it a direction.");
  }
  const Vec3 n = glm::normalize(axis);
  form.q = { 1.0 - n.x * n.x, 1.0 - n.y * n.y, 1.0 - n.z * n.z, -2.0 * n.x * n.y, -2.0 * n.y * n.z,
    -2.0 * n.x * n.z };
  form.c = -cylinder->GetRadius() * cylinder->GetRadius();
  return form;
}

// Newer cones may have one half.
template <class Cone>
std::optional<QuadricForm> FormOf(Cone* cone)
{
  if constexpr (requires { cone->GetIsDoubleCone(); })
  {
    if (!cone->GetIsDoubleCone())
    {
      return std::nullopt;
    }
  }
  constexpr double kDegree = 0.017453292519943295;
  const double slope = std::tan(cone->GetAngle() * kDegree);
  QuadricForm form;
  form.q = { -slope * slope, 1.0, 1.0, 0.0, 0.0, 0.0 };
  return form;
}

QuadricForm FormOf(vtkQuadric* quadric)
{
  double a[10];
  quadric->GetCoefficients(a);
  QuadricForm form;
  std::copy_n(a, 6, form.q.begin());
  form.g = { a[6], a[7], a[8] };
  form.c = a[9];
  return form;
}

std::optional<QuadricForm> PlainForm(vtkImplicitFunction* function)
{
  if (auto* plane = vtkPlane::SafeDownCast(function))
  {
    return FormOf(plane);
  }
  if (auto* sphere = vtkSphere::SafeDownCast(function))
  {
    return FormOf(sphere);
  }
  if (auto* cylinder = vtkCylinder::SafeDownCast(function))
  {
    return FormOf(cylinder);
  }
  if (auto* cone = vtkCone::SafeDownCast(function))
  {
    return FormOf(cone);
  }
  if (auto* quadric = vtkQuadric::SafeDownCast(function))
  {
    return FormOf(quadric);
  }
  return std::nullopt;
}

/// Of S(A x + b), about the point that goes to the form's origin.
QuadricForm Moved(const QuadricForm& form, const Mat3& a, const Vec3& b)
{
  const Mat3 matrix(Vec3(form.q[0], form.q[3] / 2.0, form.q[5] / 2.0),
    Vec3(form.q[3] / 2.0, form.q[1], form.q[4] / 2.0),
    Vec3(form.q[5] / 2.0, form.q[4] / 2.0, form.q[2]));
  const Mat3 moved = glm::transpose(a) * matrix * a;
  QuadricForm result;
  result.origin = glm::inverse(a) * (form.origin - b);
  result.q = { moved[0][0], moved[1][1], moved[2][2], 2.0 * moved[0][1], 2.0 * moved[1][2],
    2.0 * moved[0][2] };
  result.g = form.g * a;
  result.c = form.c;
  return result;
}

/// Nothing where the transform is not affine.
std::optional<QuadricForm> Moved(const QuadricForm& form, vtkImplicitFunction* function)
{
  vtkAbstractTransform* transform = function->GetTransform();
  if (transform == nullptr)
  {
    return form;
  }
  auto* homogeneous = vtkHomogeneousTransform::SafeDownCast(transform);
  if (homogeneous == nullptr)
  {
    return std::nullopt;
  }
  homogeneous->Update();
  vtkMatrix4x4* matrix = homogeneous->GetMatrix();
  if (matrix->GetElement(3, 0) != 0.0 || matrix->GetElement(3, 1) != 0.0 ||
    matrix->GetElement(3, 2) != 0.0 || matrix->GetElement(3, 3) != 1.0)
  {
    return std::nullopt;
  }
  Mat3 a;
  Vec3 b;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      a[column][row] = matrix->GetElement(row, column);
    }
    b[row] = matrix->GetElement(row, 3);
  }
  if (!(std::fabs(glm::determinant(a)) > 0.0))
  {
    throw InvalidData(std::string("the transform of the ") + function->GetClassName() +
      " has no inverse; give one that keeps volumes.");
  }
  return Moved(form, a, b);
}
} // namespace

std::unique_ptr<const CutFunction> MakeCutFunction(vtkImplicitFunction* function, double length)
{
  if (const auto plain = PlainForm(function))
  {
    if (const auto form = Moved(*plain, function))
    {
      return std::make_unique<QuadricCut>(*form);
    }
  }
  return std::make_unique<AskedFunction>(function, length);
}

std::vector<QuadricForm> PlanesOf(vtkImplicitFunction* function)
{
  std::vector<QuadricForm> planes;
  if (auto* box = vtkBox::SafeDownCast(function))
  {
    double bounds[6];
    box->GetBounds(bounds);
    for (int side = 0; side < 6; ++side)
    {
      QuadricForm form;
      form.g[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
      form.origin[side / 2] = bounds[side];
      planes.push_back(form);
    }
  }
  else if (auto* several = vtkPlanes::SafeDownCast(function))
  {
    vtkNew<vtkPlane> plane;
    for (int k = 0; k < several->GetNumberOfPlanes(); ++k)
    {
      several->GetPlane(k, plane);
      planes.push_back(FormOf(plane));
    }
  }
  for (QuadricForm& plane : planes)
  {
    const auto moved = Moved(plane, function);
    if (!moved)
    {
      throw Unsupported(
        std::string(function->GetClassName()) + ": a transform that is not affine is not taken.");
    }
    plane = *moved;
  }
  return planes;
}
} // namespace pixelexact
