// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellBasis.h"

#include "Core/Base/Error.h"

#include "vtkCellType.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
struct FixedCell
{
  int type;
  int points;
  Space space; ///< the smallest that holds the cell's functions
};

constexpr auto kCollapsed = Form::Collapsed;
constexpr FixedCell kFixedCells[] = {
  { VTK_TRIANGLE, 3, { Shape::Prism, kCollapsed, { 1, 0, 1 } } },
  { VTK_QUADRATIC_TRIANGLE, 6, { Shape::Prism, kCollapsed, { 2, 0, 2 } } },
  { VTK_BIQUADRATIC_TRIANGLE, 7, { Shape::Prism, kCollapsed, { 3, 0, 3 } } },
  { VTK_PIXEL, 4, { Shape::Hexahedron, kCollapsed, { 1, 1, 0 } } },
  { VTK_QUAD, 4, { Shape::Hexahedron, kCollapsed, { 1, 1, 0 } } },
  { VTK_QUADRATIC_LINEAR_QUAD, 6, { Shape::Hexahedron, kCollapsed, { 2, 1, 0 } } },
  { VTK_QUADRATIC_QUAD, 8, { Shape::Hexahedron, kCollapsed, { 2, 2, 0 } } },
  { VTK_BIQUADRATIC_QUAD, 9, { Shape::Hexahedron, kCollapsed, { 2, 2, 0 } } },
  { VTK_TETRA, 4, { Shape::Tetrahedron, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_TETRA, 10, { Shape::Tetrahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_VOXEL, 8, { Shape::Hexahedron, kCollapsed, { 1, 1, 1 } } },
  { VTK_HEXAHEDRON, 8, { Shape::Hexahedron, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_HEXAHEDRON, 20, { Shape::Hexahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, { Shape::Hexahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_TRIQUADRATIC_HEXAHEDRON, 27, { Shape::Hexahedron, kCollapsed, { 2, 2, 2 } } },
  { VTK_WEDGE, 6, { Shape::Prism, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_LINEAR_WEDGE, 12, { Shape::Prism, kCollapsed, { 2, 1, 2 } } },
  { VTK_QUADRATIC_WEDGE, 15, { Shape::Prism, kCollapsed, { 2, 2, 2 } } },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, { Shape::Prism, kCollapsed, { 2, 2, 2 } } },
  { VTK_PYRAMID, 5, { Shape::Pyramid, kCollapsed, { 1, 1, 1 } } },
  { VTK_QUADRATIC_PYRAMID, 13, { Shape::Pyramid, Form::Tensor, { 2, 2, 2 } } },
  // Its bubbles take a third degree towards the apex.
  { VTK_TRIQUADRATIC_PYRAMID, 19, { Shape::Pyramid, Form::Tensor, { 2, 2, 3 } } },
};

const FixedCell* Find(int type)
{
  const auto* found = std::ranges::find(kFixedCells, type, &FixedCell::type);
  return found == std::end(kFixedCells) ? nullptr : found;
}
} // namespace

bool IsFixedCell(int type)
{
  return Find(type) != nullptr;
}

CellBasis MakeFixedCellBasis(const CellKind& kind)
{
  const FixedCell& cell = *Find(kind.type);
  if (kind.points != cell.points)
  {
    throw InvalidData(CellTypeName(kind.type) + " needs " + std::to_string(cell.points) +
      " points, not " + std::to_string(kind.points) + "; the file's connectivity is damaged.");
  }
  CellBasis basis{ kind, SampleCell(kind, cell.space), {} };
  if (cell.space.form == Form::Tensor)
  {
    const FixedCell& linear = *Find(VTK_PYRAMID);
    const CellKind corners{ linear.type, linear.points, { 0, 0, 0 }, {} };
    basis.straight = { SampleCell(corners, cell.space), SampleCell(corners, linear.space) };
  }
  return basis;
}
} // namespace pixelexact
