// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Contour/ImplicitPolynomial.h"

#include "Core/Base/Error.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace pixelexact
{
namespace
{
bool IsFiniteVector(const Vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
} // namespace

double QuadraticPolynomial::At(const Vec3& z) const
{
  return q[0] * z.x * z.x + q[1] * z.y * z.y + q[2] * z.z * z.z + q[3] * z.x * z.y +
    q[4] * z.y * z.z + q[5] * z.x * z.z + glm::dot(g, z) + c;
}

Vec3 QuadraticPolynomial::GradientAt(const Vec3& z) const
{
  return g +
    Vec3(2.0 * q[0] * z.x + q[3] * z.y + q[5] * z.z, 2.0 * q[1] * z.y + q[3] * z.x + q[4] * z.z,
      2.0 * q[2] * z.z + q[4] * z.y + q[5] * z.x);
}

ImplicitPolynomial ImplicitPolynomial::Plane(const Vec3& point, const Vec3& normal)
{
  ImplicitPolynomial plane;
  plane.origin = point;
  plane.a.g = normal;
  return plane;
}

ImplicitPolynomial ImplicitPolynomial::Sphere(const Vec3& centre, double radius)
{
  ImplicitPolynomial sphere;
  sphere.origin = centre;
  sphere.a.q = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
  sphere.a.c = -radius * radius;
  return sphere;
}

ImplicitPolynomial ImplicitPolynomial::Torus(
  const Vec3& centre, const Vec3& axis, double R, double r)
{
  if (!(IsFiniteVector(centre) && IsFiniteVector(axis) && glm::length(axis) > 0.0))
  {
    throw InvalidData("the centre and the axis of a torus must be finite, and the axis not zero.");
  }
  if (!(R > 0.0 && r > 0.0 && std::isfinite(R) && std::isfinite(r)))
  {
    throw InvalidData("the radii of a torus must be greater than 0 and finite.");
  }
  const Vec3 n = glm::normalize(axis);
  ImplicitPolynomial torus;
  torus.origin = centre;
  torus.a.q = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
  torus.a.c = (R - r) * (R + r);
  torus.b.emplace();
  torus.b->q = { 1.0 - n.x * n.x, 1.0 - n.y * n.y, 1.0 - n.z * n.z, -2.0 * n.x * n.y,
    -2.0 * n.y * n.z, -2.0 * n.x * n.z };
  for (double& q : torus.b->q)
  {
    q *= 4.0 * R * R;
  }
  return torus;
}

double ImplicitPolynomial::ValueAround(const Vec3& z) const
{
  const double value = a.At(z);
  return b ? value * value - b->At(z) : value;
}

Vec3 ImplicitPolynomial::GradientAround(const Vec3& z) const
{
  const Vec3 gradient = a.GradientAt(z);
  return b ? 2.0 * a.At(z) * gradient - b->GradientAt(z) : gradient;
}

std::vector<SurfacePatch> FacesOfBody(const std::vector<ImplicitPolynomial>& planes)
{
  std::vector<SurfacePatch> faces;
  for (std::size_t k = 0; k < planes.size(); ++k)
  {
    SurfacePatch face{ planes[k], planes };
    face.clips.erase(face.clips.begin() + static_cast<std::ptrdiff_t>(k));
    faces.push_back(std::move(face));
  }
  return faces;
}

SurfacePatch DiscPatch(const Vec3& centre, const Vec3& normal, double radius)
{
  const Vec3 reach(radius * (1.0 + 1e-12));
  return { ImplicitPolynomial::Plane(centre, normal),
    { ImplicitPolynomial::Sphere(centre, radius) }, Box3{ centre - reach, centre + reach } };
}

std::optional<SurfacePatch> TrianglePatch(const std::array<Vec3, 3>& corners)
{
  const auto& [a, b, c] = corners;
  const Vec3 normal = glm::cross(b - a, c - a);
  if (!(glm::length(normal) > 0.0))
  {
    return std::nullopt;
  }
  SurfacePatch patch{ ImplicitPolynomial::Plane(a, normal) };
  for (std::size_t k = 0; k < 3; ++k)
  {
    patch.clips.push_back(
      ImplicitPolynomial::Plane(corners[k], glm::cross(corners[(k + 1) % 3] - corners[k], normal)));
  }
  patch.within = Box3{ glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c) };
  return patch;
}
} // namespace pixelexact
