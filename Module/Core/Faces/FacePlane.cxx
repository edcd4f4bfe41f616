// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Faces/FacePlane.h"

namespace pixelexact
{
namespace
{
constexpr FacePlane At(double x, double y, double z, double constant)
{
  return { { x, y, z }, constant };
}

constexpr FacePlane kHexahedron[] = { At(0, 0, 1, 1), At(1, 0, 0, 1), At(-1, 0, 0, 1),
  At(0, 1, 0, 1), At(0, -1, 0, 1), At(0, 0, -1, 1) };
constexpr FacePlane kPrism[] = { At(0, 0, 1, 1), At(1, 0, 0, 1), At(-1, 0, -1, 0), At(0, 1, 0, 1),
  At(0, -1, 0, 1) };
constexpr FacePlane kTetrahedron[] = { At(0, 0, 1, 1), At(1, 0, 0, 1), At(-1, -1, -1, -1),
  At(0, 1, 0, 1) };
constexpr FacePlane kPyramid[] = { At(0, 0, 1, 1), At(1, 0, 0, 1), At(-1, 0, -1, 0), At(0, 1, 0, 1),
  At(0, -1, -1, 0) };
} // namespace

std::span<const FacePlane> FacePlanesOf(Shape shape)
{
  switch (shape)
  {
    case Shape::Hexahedron:
      return kHexahedron;
    case Shape::Prism:
      return kPrism;
    case Shape::Tetrahedron:
      return kTetrahedron;
    default:
      return kPyramid;
  }
}
} // namespace pixelexact
