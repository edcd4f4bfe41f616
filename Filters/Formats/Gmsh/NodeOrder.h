// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <array>
#include <vector>

// Where the nodes of Gmsh's elements are (reference manual, "Node ordering"): vertices, edges,
// faces, interior; inside of faces and elements the same again, of a lower order.
namespace pixelexact::gmsh
{
/// A node by its count of steps, of 1 / order, along Gmsh's u, v, w from the first vertex. In a
/// pyramid layer w has order - w steps along u and v.
using Lattice = std::array<int, 3>;

/// The nodes of a complete element, in Gmsh's order; order >= 0.
std::vector<Lattice> NodeOrder(Shape shape, int order);

/// The nodes of a complete triangle or quadrilateral, with steps along u and v.
std::vector<Lattice> PlaneOrder(bool triangle, int order);

/// The corners of each face, -1 behind those of triangles, by the element's corners, and the face's
/// number in VTK's linear cell.
struct ElementFace
{
  std::array<int, 4> corners;
  int vtkFace;
};
const std::vector<ElementFace>& FacesOf(Shape shape);

/// The edges of a triangle or quadrilateral, and the faces behind them in VTK's linear cell of the
/// slab (planar.md).
const std::vector<ElementFace>& SidesOf(bool triangle);
} // namespace pixelexact::gmsh
