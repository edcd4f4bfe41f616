// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/FunctionOfSurface.h"

#include "Trace/Surfaces/ConvexBody.h"
#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"
#include "Trace/Surfaces/Torus.h"
#include "vtkImplicitTorus.h"

#include "vtkBox.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkQuadric.h"
#include "vtkTransform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pixelexact
{
namespace
{
vtkSmartPointer<vtkImplicitFunction> FunctionOf(const Plane& plane)
{
  const Vec3& point = plane.Through();
  const Vec3 normal = plane.Normal({ point });
  auto function = vtkSmartPointer<vtkPlane>::New();
  function->SetOrigin(point.x, point.y, point.z);
  function->SetNormal(normal.x, normal.y, normal.z);
  return function;
}

vtkSmartPointer<vtkImplicitFunction> FunctionOf(const Quadric& quadric)
{
  const QuadraticForm& form = quadric.GetForm();
  auto function = vtkSmartPointer<vtkQuadric>::New();
  function->SetCoefficients(form.Q[0].high, form.Q[1].high, form.Q[2].high, 2.0 * form.Q[3].high,
    2.0 * form.Q[4].high, 2.0 * form.Q[5].high, 2.0 * form.b[0].high, 2.0 * form.b[1].high,
    2.0 * form.b[2].high, form.k.high);
  if (form.centre != Vec3(0.0))
  {
    vtkNew<vtkTransform> toCentre;
    toCentre->Translate(-form.centre.x, -form.centre.y, -form.centre.z);
    function->SetTransform(toCentre);
  }
  return function;
}

vtkSmartPointer<vtkImplicitFunction> FunctionOf(const Torus& torus)
{
  auto function = vtkSmartPointer<vtkImplicitTorus>::New();
  const Vec3& centre = torus.Centre();
  const Vec3& axis = torus.AxisDirection();
  function->SetCenter(centre.x, centre.y, centre.z);
  function->SetAxis(axis.x, axis.y, axis.z);
  function->SetRadius(torus.Radius());
  function->SetTubeRadius(torus.Tube());
  return function;
}

/// Null if the body is not an axis-aligned box.
vtkSmartPointer<vtkImplicitFunction> FunctionOf(const ConvexBody& body)
{
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::array<double, 6> bounds{ kNone, kNone, kNone, kNone, kNone, kNone };
  for (const ConvexFace& face : body.PlanesOfFaces())
  {
    for (int d = 0; d < 3; ++d)
    {
      Vec3 axis(0.0);
      axis[d] = face.normal[d];
      if (axis == face.normal && axis[d] != 0.0)
      {
        bounds[2 * static_cast<std::size_t>(d) + (axis[d] > 0.0 ? 1 : 0)] = face.point[d];
      }
    }
  }
  const bool whole = std::ranges::none_of(bounds, [](double end) { return std::isnan(end); });
  if (!whole || body.PlanesOfFaces().size() != bounds.size())
  {
    return nullptr;
  }
  auto function = vtkSmartPointer<vtkBox>::New();
  function->SetBounds(bounds.data());
  return function;
}
} // namespace

vtkSmartPointer<vtkImplicitFunction> FunctionOf(const Surface& surface)
{
  if (const auto* plane = dynamic_cast<const Plane*>(&surface))
  {
    return FunctionOf(*plane);
  }
  if (const auto* quadric = dynamic_cast<const Quadric*>(&surface))
  {
    return FunctionOf(*quadric);
  }
  if (const auto* torus = dynamic_cast<const Torus*>(&surface))
  {
    return FunctionOf(*torus);
  }
  if (const auto* body = dynamic_cast<const ConvexBody*>(&surface))
  {
    return FunctionOf(*body);
  }
  return nullptr;
}
} // namespace pixelexact
