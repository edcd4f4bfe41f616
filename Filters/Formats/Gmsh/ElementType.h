// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <array>
#include <string>
#include <vector>

// Gmsh's numbers for types of elements (reference manual, "MSH file format"). Only this file and
// its source contain them.

namespace pixelexact::gmsh
{
struct ElementType
{
  int number = 0; ///< Gmsh's
  int dimension = 0;
  int corners = 0;      ///< nodes that are vertices; they come first
  int nodes = 0;        ///< all of them
  int order = 0;        ///< of its polynomials
  bool complete = true; ///< false: without nodes in faces and interior
  /// The shape of an element of dimension 3. For dimension 2 that of the slab's solid
  /// (bases-and-kernels.md).
  Shape shape = Shape::Hexahedron;
};

/// The type of a number. Null for unknown numbers and for elements without a fixed number of nodes
/// (polygons, polyhedra, borders, elements of extended finite elements).
const ElementType* FindType(int number);

/// "hexahedra of order 3 with 32 nodes (type 99)", "elements of type 35".
std::string Describe(int number);

// The order of nodes in Gmsh's elements (reference manual, "Node ordering"): vertices, edges,
// faces, interior. Nodes inside faces and elements follow the same order at a lower polynomial
// order.

/// A node by its count of steps, of 1 / order, along Gmsh's u, v, w from the first vertex. In a
/// pyramid layer w has order - w steps along u and v.
using Lattice = std::array<int, 3>;

/// The nodes of a complete element, in Gmsh's order; order >= 0.
std::vector<Lattice> NodeOrder(Shape shape, int order);

/// The nodes of a complete triangle or quadrilateral, with steps along u and v.
std::vector<Lattice> PlaneOrder(bool triangle, int order);

/// The corners of each face as the element's corners, -1 after those of triangles, and the face's
/// number in VTK's linear cell.
struct ElementFace
{
  std::array<int, 4> corners;
  int vtkFace;
};
const std::vector<ElementFace>& FacesOf(Shape shape);

/// The edges of a triangle or quadrilateral, and their faces in VTK's linear cell of the slab
/// (bases-and-kernels.md).
const std::vector<ElementFace>& SidesOf(bool triangle);
} // namespace pixelexact::gmsh
