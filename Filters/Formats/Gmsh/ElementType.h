// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Shape/Shape.h"

#include <string>

// Gmsh's numbers for types of elements (reference manual, "MSH file format"). The only file set
// that knows them.
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
  /// Of dimension 3; of dimension 2 that of the slab's solid (planar.md).
  Shape shape = Shape::Hexahedron;
};

/// Null for numbers that stand for none, or for elements without a fixed number of nodes (polygons,
/// polyhedra, borders, elements of extended finite elements).
const ElementType* FindType(int number);

/// "hexahedra of order 3 with 32 nodes (type 99)", "elements of type 35".
std::string Describe(int number);
} // namespace pixelexact::gmsh
