// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/CutFunction.h"

#include "Core/Base/Error.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace pixelexact
{
namespace
{
bool IsFinite(const Vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
} // namespace

QuarticForm QuarticForm::Torus(const Vec3& centre, const Vec3& axis, double R, double r)
{
  if (!(IsFinite(centre) && IsFinite(axis) && glm::length(axis) > 0.0))
  {
    throw InvalidData("the centre and the axis of a torus must be finite, and the axis not zero.");
  }
  if (!(R > 0.0 && r > 0.0 && std::isfinite(R) && std::isfinite(r)))
  {
    throw InvalidData("the radii of a torus must be greater than 0 and finite.");
  }
  const Vec3 n = glm::normalize(axis);
  QuarticForm form;
  form.a.origin = centre;
  form.a.q = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
  form.a.c = (R - r) * (R + r);
  form.b.origin = centre;
  form.b.q = { 1.0 - n.x * n.x, 1.0 - n.y * n.y, 1.0 - n.z * n.z, -2.0 * n.x * n.y,
    -2.0 * n.y * n.z, -2.0 * n.x * n.z };
  for (double& q : form.b.q)
  {
    q *= 4.0 * R * R;
  }
  return form;
}

double QuarticForm::ValueAround(const Vec3& z) const
{
  const double square = a.ValueAround(z);
  return square * square - b.ValueAround(z);
}

Vec3 QuarticForm::GradientAround(const Vec3& z) const
{
  return 2.0 * a.ValueAround(z) * a.GradientAround(z) - b.GradientAround(z);
}

TorusCut::TorusCut(const Vec3& centre, const Vec3& axis, double R, double r)
  : Form(QuarticForm::Torus(centre, axis, R, r))
  , Axis(glm::normalize(axis))
  , CircleRadius(R)
  , TubeRadius(r)
{
}

double TorusCut::Value(const Vec3& x) const
{
  const Vec3 z = x - Form.a.origin;
  if (TubeRadius > CircleRadius)
  {
    return Form.ValueAround(z);
  }
  const double height = glm::dot(z, Axis);
  const double aside = glm::length(z - height * Axis) - CircleRadius;
  return aside * aside + height * height - TubeRadius * TubeRadius;
}

Vec3 TorusCut::Gradient(const Vec3& x) const
{
  const Vec3 z = x - Form.a.origin;
  if (TubeRadius > CircleRadius)
  {
    return Form.GradientAround(z);
  }
  const double height = glm::dot(z, Axis);
  const Vec3 across = z - height * Axis;
  const double rho = glm::length(across);
  // On the axis there is no direction across it.
  const double outwards = rho > 0.0 ? (rho - CircleRadius) / rho : 0.0;
  return 2.0 * (outwards * across + height * Axis);
}

double QuadricForm::ValueAround(const Vec3& z) const
{
  return q[0] * z.x * z.x + q[1] * z.y * z.y + q[2] * z.z * z.z + q[3] * z.x * z.y +
    q[4] * z.y * z.z + q[5] * z.x * z.z + glm::dot(g, z) + c;
}

Vec3 QuadricForm::GradientAround(const Vec3& z) const
{
  return g +
    Vec3(2.0 * q[0] * z.x + q[3] * z.y + q[5] * z.z, 2.0 * q[1] * z.y + q[3] * z.x + q[4] * z.z,
      2.0 * q[2] * z.z + q[4] * z.y + q[5] * z.x);
}

void CutFunction::Values(std::span<const Vec3> x, std::span<double> values) const
{
  std::ranges::transform(x, values.begin(), [this](const Vec3& at) { return Value(at); });
}

void CutFunction::Gradients(std::span<const Vec3> x, std::span<Vec3> gradients) const
{
  std::ranges::transform(x, gradients.begin(), [this](const Vec3& at) { return Gradient(at); });
}
} // namespace pixelexact
