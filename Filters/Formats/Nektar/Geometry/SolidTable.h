// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact::nektar
{
struct SolidFace
{
  int corners;                 ///< 3 or 4
  std::array<int, 4> vertices; ///< around the face
  std::int8_t vtkFace;         ///< the same face in VTK's linear cell
};

/// Nektar++'s numbering of a solid.
struct SolidTable
{
  std::vector<Vec3> vertices; ///< in xi
  std::vector<SolidFace> faces;
  /// Per vertex, faces that meet in it alone.
  std::vector<std::array<int, 3>> meeting;
  /// Per vertex of VTK's linear cell, Nektar++'s vertex.
  std::vector<int> vtkVertex;
};

const SolidTable& TableOf(Shape shape);
} // namespace pixelexact::nektar
