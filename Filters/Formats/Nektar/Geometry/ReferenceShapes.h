// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Basis/BasisFactor.h"
#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <array>
#include <span>
#include <vector>

// The modified basis (Karniadakis and Sherwin, section 3.2), as Nektar++ orders and uses it.

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
  /// Per vertex, three faces that have only this vertex in common.
  std::vector<std::array<int, 3>> meeting;
  /// Per vertex of VTK's linear cell, Nektar++'s vertex.
  std::vector<int> vtkVertex;
};

const SolidTable& TableOf(Shape shape);

/// A mode by its three indices.
struct Mode
{
  int p;
  int q;
  int r;
};

/// The modes of a shape with `count` modes along each direction, in the order of the files.
std::vector<Mode> ModesOf(Shape shape, const std::array<int, 3>& count);

/// Whether a mode of the modified basis vanishes on the shape's boundary.
bool IsInterior(Shape shape, const Mode& mode);

/// A_n(z): the vertex functions (1 - z) / 2 and (1 + z) / 2, then bubbles.
long double ModifiedA(int n, long double z);

/// The mode's value at xi of the shape's inside.
long double ModifiedMode(Shape shape, const Mode& mode, const LongVec3& xi);

/// The same for the orthogonal basis; pyramids throw Unsupported.
long double OrthogonalMode(Shape shape, const Mode& mode, const LongVec3& xi);
} // namespace pixelexact::nektar
