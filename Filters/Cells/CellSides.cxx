// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/CellSides.h"

#include <vtkCellType.h>

namespace pixelexact
{
namespace
{
// CellBasis.h places VTK's corners in xi.
constexpr std::array kHexahedron{ CellSide{ { 0, 1, 5, 4 }, 4, 3 },
  CellSide{ { 1, 2, 6, 5 }, 4, 2 }, CellSide{ { 2, 3, 7, 6 }, 4, 4 },
  CellSide{ { 0, 4, 7, 3 }, 4, 1 }, CellSide{ { 0, 3, 2, 1 }, 4, 0 },
  CellSide{ { 4, 5, 6, 7 }, 4, 5 } };
constexpr std::array kTetrahedron{ CellSide{ { 0, 1, 3 }, 3, 3 }, CellSide{ { 1, 2, 3 }, 3, 2 },
  CellSide{ { 0, 3, 2 }, 3, 1 }, CellSide{ { 0, 2, 1 }, 3, 0 } };
constexpr std::array kWedge{ CellSide{ { 0, 1, 4, 3 }, 4, 0 }, CellSide{ { 1, 2, 5, 4 }, 4, 2 },
  CellSide{ { 0, 3, 5, 2 }, 4, 1 }, CellSide{ { 0, 2, 1 }, 3, 4 }, CellSide{ { 3, 4, 5 }, 3, 3 } };
constexpr std::array kPyramid{ CellSide{ { 0, 1, 4 }, 3, 3 }, CellSide{ { 1, 2, 4 }, 3, 2 },
  CellSide{ { 2, 3, 4 }, 3, 4 }, CellSide{ { 0, 4, 3 }, 3, 1 }, CellSide{ { 0, 3, 2, 1 }, 4, 0 } };
constexpr std::array kTriangle{ CellSide{ { 0, 1 }, 2, 0 }, CellSide{ { 1, 2 }, 2, 2 },
  CellSide{ { 2, 0 }, 2, 1 } };
constexpr std::array kQuadrilateral{ CellSide{ { 0, 1 }, 2, 3 }, CellSide{ { 1, 2 }, 2, 2 },
  CellSide{ { 2, 3 }, 2, 4 }, CellSide{ { 3, 0 }, 2, 1 } };
} // namespace

std::span<const CellSide> SidesOf(int cellType)
{
  switch (cellType)
  {
    case VTK_HEXAHEDRON:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
      return kHexahedron;
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TETRAHEDRON:
      return kTetrahedron;
    case VTK_WEDGE:
    case VTK_QUADRATIC_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
      return kWedge;
    case VTK_PYRAMID:
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
    case VTK_LAGRANGE_PYRAMID:
      return kPyramid;
    case VTK_TRIANGLE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
      return kTriangle;
    case VTK_QUAD:
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
      return kQuadrilateral;
    default:
      return {};
  }
}
} // namespace pixelexact
