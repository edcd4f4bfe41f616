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
/// Evaluates a vtkImplicitFunction at each point that needs a value.
class AskedFunction final : public CutFunction
{
public:
  AskedFunction(vtkImplicitFunction* function, double length)
    : Function(function)
    , AtOnce(HasCallbacks(function))
    , Step(1e-6 * length)
  {
  }
  void Values(std::span<const Vec3> x, std::span<double> values) const override
  {
    AtOnce ? FunctionValues(Function, x, values) : AskOneByOne(x, values);
    const auto missing =
      std::ranges::find_if(values, [](double value) { return std::isnan(value); });
    if (missing != values.end())
    {
      // Fails at the first NaN, so that a failing function is not called a million more times.
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
  /// Evaluates point by point on the calling thread. VTK's functions for arrays of points may use
  /// several threads.
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

QuadraticPolynomial RoundAbout(const Vec3& axis, double radius)
{
  const Vec3 n = glm::normalize(axis);
  return { { 1.0 - n.x * n.x, 1.0 - n.y * n.y, 1.0 - n.z * n.z, -2.0 * n.x * n.y, -2.0 * n.y * n.z,
             -2.0 * n.x * n.z },
    Vec3(0.0), -radius * radius };
}

ImplicitPolynomial FormOf(vtkPlane* plane)
{
  ImplicitPolynomial form;
  plane->GetOrigin(glm::value_ptr(form.origin));
  // Uses the function itself, not GetNormal(): newer planes also have an offset along the normal.
  plane->EvaluateGradient(glm::value_ptr(form.origin), glm::value_ptr(form.a.g));
  if (form.a.g == Vec3(0.0))
  {
    throw InvalidData("the normal of the vtkPlane is zero; give it a direction.");
  }
  form.a.c = plane->EvaluateFunction(glm::value_ptr(form.origin));
  return form;
}

ImplicitPolynomial FormOf(vtkCylinder* cylinder)
{
  ImplicitPolynomial form;
  Vec3 axis;
  cylinder->GetCenter(glm::value_ptr(form.origin));
  cylinder->GetAxis(glm::value_ptr(axis));
  if (axis == Vec3(0.0))
  {
    throw InvalidData("the axis of the vtkCylinder is zero; give it a direction.");
  }
  form.a = RoundAbout(axis, cylinder->GetRadius());
  return form;
}

// Newer cones may have one half only.
template <class Cone>
std::optional<ImplicitPolynomial> FormOf(Cone* cone)
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
  ImplicitPolynomial form;
  form.a.q = { -slope * slope, 1.0, 1.0, 0.0, 0.0, 0.0 };
  return form;
}

ImplicitPolynomial FormOf(vtkQuadric* quadric)
{
  const double* const a = quadric->GetCoefficients();
  ImplicitPolynomial form;
  std::copy_n(a, 6, form.a.q.begin());
  form.a.g = { a[6], a[7], a[8] };
  form.a.c = a[9];
  return form;
}

/// The polynomial of `function` without its transform.
std::optional<ImplicitPolynomial> PlainForm(vtkImplicitFunction* function)
{
  if (auto* plane = vtkPlane::SafeDownCast(function))
  {
    return FormOf(plane);
  }
  if (auto* sphere = vtkSphere::SafeDownCast(function))
  {
    Vec3 centre;
    sphere->GetCenter(glm::value_ptr(centre));
    return ImplicitPolynomial::Sphere(centre, sphere->GetRadius());
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
  if (auto* torus = vtkImplicitTorus::SafeDownCast(function))
  {
    Vec3 centre;
    Vec3 axis;
    torus->GetCenter(glm::value_ptr(centre));
    torus->GetAxis(glm::value_ptr(axis));
    return ImplicitPolynomial::Torus(centre, axis, torus->GetRadius(), torus->GetTubeRadius());
  }
  return std::nullopt;
}

/// Returns S(A z) as a polynomial of z.
QuadraticPolynomial Turned(const QuadraticPolynomial& form, const Mat3& a)
{
  const auto& q = form.q;
  const Mat3 matrix(Vec3(q[0], q[3] / 2.0, q[5] / 2.0), Vec3(q[3] / 2.0, q[1], q[4] / 2.0),
    Vec3(q[5] / 2.0, q[4] / 2.0, q[2]));
  const Mat3 turned = glm::transpose(a) * matrix * a;
  return { { turned[0][0], turned[1][1], turned[2][2], 2.0 * turned[0][1], 2.0 * turned[1][2],
             2.0 * turned[0][2] },
    form.g * a, form.c };
}

/// Returns S(A x + b) about the point that the transform moves to the form's origin; nothing where
/// the transform is not affine.
std::optional<ImplicitPolynomial> Moved(
  const ImplicitPolynomial& form, vtkImplicitFunction* function)
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
  ImplicitPolynomial moved{ glm::inverse(a) * (form.origin - b), Turned(form.a, a), std::nullopt };
  if (form.b)
  {
    moved.b = Turned(*form.b, a);
  }
  return moved;
}

/// The planes of a vtkBox or vtkPlanes, with normals that point out of it; none of other functions.
std::vector<ImplicitPolynomial> PlanesOf(vtkImplicitFunction* function)
{
  std::vector<ImplicitPolynomial> planes;
  if (auto* box = vtkBox::SafeDownCast(function))
  {
    double bounds[6];
    box->GetBounds(bounds);
    for (int side = 0; side < 6; ++side)
    {
      ImplicitPolynomial plane;
      plane.a.g[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
      plane.origin[side / 2] = bounds[side];
      planes.push_back(plane);
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
  for (ImplicitPolynomial& plane : planes)
  {
    const auto moved = Moved(plane, function);
    if (!moved)
    {
      return {};
    }
    plane = *moved;
  }
  return planes;
}
} // namespace

std::optional<ImplicitPolynomial> PolynomialOf(vtkImplicitFunction* function)
{
  const auto plain = PlainForm(function);
  return plain ? Moved(*plain, function) : std::nullopt;
}

std::vector<ImplicitPolynomial> ClipsOf(vtkImplicitFunction* function)
{
  if (const auto polynomial = PolynomialOf(function))
  {
    return { *polynomial };
  }
  return PlanesOf(function);
}

std::vector<SurfacePatch> PatchesOf(vtkImplicitFunction* function)
{
  if (const auto polynomial = PolynomialOf(function))
  {
    return { { *polynomial } };
  }
  return FacesOfBody(PlanesOf(function));
}

std::unique_ptr<const CutFunction> MakeCutFunction(vtkImplicitFunction* function, double length)
{
  if (const auto polynomial = PolynomialOf(function))
  {
    return std::make_unique<PolynomialCut>(*polynomial);
  }
  return std::make_unique<AskedFunction>(function, length);
}
} // namespace pixelexact
