// SPDX-License-Identifier: BSD-3-Clause
#include "FunctionOfSurface.h"

#include "Trace/Surfaces/Plane.h"
#include "Trace/Surfaces/Quadric.h"

#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkQuadric.h"
#include "vtkTransform.h"

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
  return nullptr;
}
} // namespace pixelexact
