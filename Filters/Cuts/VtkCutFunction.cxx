// SPDX-License-Identifier: BSD-3-Clause
#include "Cuts/VtkCutFunction.h"

#include "CallbackWatch.h"
#include "Core/Base/Error.h"
#include "Core/Math/Mat.h"
#include "FunctionValues.h"
#include "vtkImplicitTorus.h"

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
#include <span>
#include <sstream>
#include <string>
#include <vector>

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
    , AtOnce(HasCallbacks(function))
    , Step(1e-6 * length)
  {
  }
  [[nodiscard]] double Value(const Vec3& x) const override
  {
    double value = 0.0;
    Values({ &x, 1 }, { &value, 1 });
    return value;
  }
  [[nodiscard]] Vec3 Gradient(const Vec3& x) const override
  {
    Vec3 gradient;
    Gradients({ &x, 1 }, { &gradient, 1 });
    return gradient;
  }
  void Values(std::span<const Vec3> x, std::span<double> values) const override
  {
    AtOnce ? FunctionValues(Function, x, values) : AskOneByOne(x, values);
    const auto missing =
      std::ranges::find_if(values, [](double value) { return std::isnan(value); });
    if (missing != values.end())
    {
      // So a function that fails is not asked a million times more.
      const Vec3& at = x[static_cast<std::size_t>(missing - values.begin())];
      std::ostringstream text;
      text << "the " << Function->GetClassName() << " has no value at (" << at.x << ", " << at.y
           << ", " << at.z << "); give a function that has one in all of the mesh's box.";
      throw InvalidData(text.str());
    }
  }
  void Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const override
  {
    std::vector<Vec3> ends;
    ends.reserve(6 * x.size());
    for (const Vec3& at : x)
    {
      for (int d = 0; d < 3; ++d)
      {
        for (const double step : { -Step, Step })
        {
          ends.push_back(at);
          ends.back()[d] += step;
        }
      }
    }
    std::vector<double> values(ends.size());
    Values(ends, values);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      for (int d = 0; d < 3; ++d)
      {
        const std::size_t k = 6 * i + 2 * static_cast<std::size_t>(d);
        gradients[i][d] = (values[k + 1] - values[k]) / (ends[k + 1][d] - ends[k][d]);
      }
    }
  }
  [[nodiscard]] bool NeedsCallingThread() const override { return true; }

private:
  /// By this thread alone, as VTK's functions for many points are not.
  void AskOneByOne(std::span<const Vec3> x, std::span<double> values) const
  {
    const CallbackWatch watch;
    for (std::size_t i = 0; i < x.size() && watch.failure.empty(); ++i)
    {
      values[i] = Function->FunctionValue(glm::value_ptr(x[i]));
    }
    if (!watch.failure.empty())
    {
      throw Error(watch.failure);
    }
  }

  vtkSmartPointer<vtkImplicitFunction> Function;
  bool AtOnce;
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
  auto* torus = vtkImplicitTorus::SafeDownCast(function);
  if (torus != nullptr && torus->GetTransform() == nullptr &&
    torus->GetTubeRadius() <= torus->GetRadius())
  {
    const double* const c = torus->GetCenter();
    const double* const a = torus->GetAxis();
    return std::make_unique<TorusCut>(
      Vec3(c[0], c[1], c[2]), Vec3(a[0], a[1], a[2]), torus->GetRadius(), torus->GetTubeRadius());
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
