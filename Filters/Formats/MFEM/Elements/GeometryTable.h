// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/MFEM/Elements/Collection.h"

#include <array>
#include <span>

namespace pixelexact::mfem
{
/// How MFEM numbers the vertices of an edge or a face in its element.
struct LocalFace
{
  Geometry geometry;           ///< Triangle or Square
  std::array<int, 4> vertices; ///< the fourth is -1 for triangles
  std::int8_t vtkFace;         ///< the same face in VTK's linear cell
};

struct GeometryTable
{
  int vertices = 0;
  std::span<const std::array<int, 2>> edges;
  std::span<const LocalFace> faces;
  /// Of plane elements: the faces behind their edges in VTK's linear cell of the slab.
  std::span<const std::int8_t> sides{};
};

/// The table of a solid or plane element, or of a segment, which has vertices only.
const GeometryTable& TableOf(Geometry geometry);
} // namespace pixelexact::mfem
