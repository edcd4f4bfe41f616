// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Shape/ShapeFace.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
// Collapse `a` towards -1 as `b` goes to 1.
double Collapse(double a, double b)
{
  return (1.0 + a) * (1.0 - b) / 2.0 - 1.0;
}
double Expand(double a, double oneMinusB)
{
  return oneMinusB > 0.0 ? 2.0 * (1.0 + a) / oneMinusB - 1.0 : -1.0;
}

constexpr ShapeFace kFaces[] = { { 2, false }, { 0, false }, { 0, true }, { 1, false }, { 1, true },
  { 2, true } };
/// A tetrahedron's eta2 = 1 is collapsed.
constexpr ShapeFace kTetrahedronFaces[] = { { 2, false }, { 0, false }, { 0, true }, { 1, false } };
} // namespace

const char* Name(Shape shape)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return "hexahedron";
    case Shape::Prism:
      return "prism";
    case Shape::Tetrahedron:
      return "tetrahedron";
    default:
      return "pyramid";
  }
}

Vec3 TensorToReference(Shape shape, const Vec3& eta)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return eta;
    case Shape::Prism:
      return { Collapse(eta.x, eta.z), eta.y, eta.z };
    case Shape::Tetrahedron:
      return { (1.0 + eta.x) * (1.0 - eta.y) * (1.0 - eta.z) / 4.0 - 1.0, Collapse(eta.y, eta.z),
        eta.z };
    default:
      return { Collapse(eta.x, eta.z), Collapse(eta.y, eta.z), eta.z };
  }
}

Vec3 ReferenceToTensor(Shape shape, const Vec3& xi)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return xi;
    case Shape::Prism:
      return { Expand(xi.x, 1.0 - xi.z), xi.y, xi.z };
    case Shape::Tetrahedron:
      return { Expand(xi.x, -xi.y - xi.z), Expand(xi.y, 1.0 - xi.z), xi.z };
    default:
      return { Expand(xi.x, 1.0 - xi.z), Expand(xi.y, 1.0 - xi.z), xi.z };
  }
}

double Margin(Shape shape, const Vec3& xi)
{
  // std::min drops a NaN in its second argument; a sum that is NaN whenever any coordinate is
  // stands first.
  const double nan = 0.0 * (xi.x + xi.y + xi.z);
  const double low = std::min({ nan + 1.0 + xi.x, 1.0 + xi.y, 1.0 + xi.z });
  switch (shape)
  {
    case Shape::Hexahedron:
      return std::min({ low, 1.0 - xi.x, 1.0 - xi.y, 1.0 - xi.z });
    case Shape::Prism:
      return std::min({ low, 1.0 - xi.y, -(xi.x + xi.z) });
    case Shape::Tetrahedron:
      return std::min(low, -(1.0 + xi.x + xi.y + xi.z));
    default:
      return std::min({ low, -(xi.x + xi.z), -(xi.y + xi.z) });
  }
}

Vec3 Centre(Shape shape)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return Vec3(0.0);
    case Shape::Prism:
      return { -1.0 / 3.0, 0.0, -1.0 / 3.0 };
    case Shape::Tetrahedron:
      return Vec3(-0.5);
    default:
      return { -0.2, -0.2, -0.6 };
  }
}

std::span<const ShapeFace> FacesOf(Shape shape)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return kFaces;
    case Shape::Tetrahedron:
      return kTetrahedronFaces;
    default:
      return std::span(kFaces).first(5);
  }
}
} // namespace pixelexact
