// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShapeLattice_h
#define ShapeLattice_h

#include "Core/Math/Vec.h"
#include "Core/Shape/Shape.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// A shape's reference space, cut into linear cells of VTK's: each edge of the shape into as many
/// parts, faces into squares and triangles of them, so that cells of neighbours fit. A hexahedron
/// becomes n^3 hexahedra, a prism n^3 wedges, a tetrahedron n^3 tetrahedra, a pyramid n (2 n^2 + 1)
/// / 3 pyramids and 2 n (n^2 - 1) / 3 tetrahedra.
struct ShapeLattice
{
  std::vector<Vec3> points;         ///< in xi, each once
  std::vector<unsigned char> types; ///< VTK's, per cell
  std::vector<int> offsets{ 0 };    ///< into `corners`, one more than cells
  std::vector<int>
    corners; ///< numbers of points, in VTK's order; volumes (VolumeOf) in xi are positive

  [[nodiscard]] std::size_t Cells() const { return types.size(); }
  [[nodiscard]] std::span<const int> Corners(std::size_t cell) const
  {
    return std::span(corners).subspan(static_cast<std::size_t>(offsets[cell]),
      static_cast<std::size_t>(offsets[cell + 1] - offsets[cell]));
  }
};

/// `parts`, n above, at least 1.
[[nodiscard]] ShapeLattice MakeShapeLattice(Shape shape, int parts);
} // namespace pixelexact
#endif
