// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <span>

namespace pixelexact
{
/// A face of a shape: an end of the cube of eta that is not collapsed.
struct ShapeFace
{
  int direction = 0;  ///< of eta
  bool upper = false; ///< eta_direction = 1, not -1
};

/// All faces of a shape.
std::span<const ShapeFace> FacesOf(Shape shape);

/// The direction of eta across the slab that stands for a plane mesh, whose elements are prisms and
/// hexahedra.
constexpr int AcrossSlab(Shape shape)
{
  return shape == Shape::Prism ? 1 : 2;
}

/// The face of a prism or hexahedron that stands for a triangle or quadrilateral of a surface in
/// space. The solid beneath it is there for the kernels alone.
constexpr int ShellFace(Shape shape)
{
  return shape == Shape::Prism ? 3 : 5;
}
} // namespace pixelexact
