// SPDX-License-Identifier: BSD-3-Clause
// Orders of nodes: "Exodus Element Types" of SEACAS, and of VTK's cells their own interpolation
// functions. TETRA15 has its faces as (0,1,2), (1,2,3), (0,2,3), (0,1,3), and then the centre.
// WEDGE21 has the centre first, then the triangles, and of the quadrilaterals (0,1,4,3) last.
#include "Files/ExodusCells.h"

#include "vtkCellType.h"

#include <algorithm>

namespace pixelexact
{
namespace
{
constexpr std::array kHexahedron{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14,
  15, 23, 24, 25, 26, 21, 22, 20 };
constexpr std::array kTetrahedron{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 13, 11, 12, 14 };
constexpr std::array kWedge18{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11, 15, 16, 17 };
constexpr std::array kWedge21{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11, 16, 17, 20, 18, 19,
  15 };

struct Element
{
  const char* begin; ///< of the type's name
  int nodes;
  int cell;
  std::span<const int> order{};
};

constexpr std::array kElements{
  Element{ "HEX", 8, VTK_HEXAHEDRON },
  Element{ "HEX", 20, VTK_QUADRATIC_HEXAHEDRON, std::span(kHexahedron).first(20) },
  Element{ "HEX", 27, VTK_TRIQUADRATIC_HEXAHEDRON, kHexahedron },
  Element{ "TET", 4, VTK_TETRA },
  Element{ "TET", 10, VTK_QUADRATIC_TETRA },
  Element{ "TET", 15, VTK_LAGRANGE_TETRAHEDRON, kTetrahedron },
  Element{ "WED", 6, VTK_WEDGE },
  Element{ "WED", 15, VTK_QUADRATIC_WEDGE, std::span(kWedge18).first(15) },
  Element{ "WED", 18, VTK_BIQUADRATIC_QUADRATIC_WEDGE, kWedge18 },
  Element{ "WED", 21, VTK_LAGRANGE_WEDGE, kWedge21 },
  Element{ "PYR", 5, VTK_PYRAMID },
  Element{ "PYR", 13, VTK_QUADRATIC_PYRAMID },
  Element{ "TRI", 3, VTK_TRIANGLE },
  Element{ "TRI", 6, VTK_QUADRATIC_TRIANGLE },
  Element{ "QUA", 4, VTK_QUAD },
  Element{ "QUA", 8, VTK_QUADRATIC_QUAD },
  Element{ "QUA", 9, VTK_BIQUADRATIC_QUAD },
  Element{ "SHE", 3, VTK_TRIANGLE },
  Element{ "SHE", 4, VTK_QUAD },
  Element{ "SHE", 8, VTK_QUADRATIC_QUAD },
  Element{ "SHE", 9, VTK_BIQUADRATIC_QUAD },
  Element{ "BAR", 2, VTK_LINE },
  Element{ "BAR", 3, VTK_QUADRATIC_EDGE },
  Element{ "BEA", 2, VTK_LINE },
  Element{ "BEA", 3, VTK_QUADRATIC_EDGE },
  Element{ "TRU", 2, VTK_LINE },
  Element{ "TRU", 3, VTK_QUADRATIC_EDGE },
  Element{ "EDG", 2, VTK_LINE },
  Element{ "EDG", 3, VTK_QUADRATIC_EDGE },
  Element{ "SPH", 1, VTK_VERTEX },
  Element{ "CIR", 1, VTK_VERTEX },
};

// CellBasis.h places VTK's corners in xi.
constexpr std::array kHexahedronSides{ CellSide{ { 0, 1, 5, 4 }, 4, 3 },
  CellSide{ { 1, 2, 6, 5 }, 4, 2 }, CellSide{ { 2, 3, 7, 6 }, 4, 4 },
  CellSide{ { 0, 4, 7, 3 }, 4, 1 }, CellSide{ { 0, 3, 2, 1 }, 4, 0 },
  CellSide{ { 4, 5, 6, 7 }, 4, 5 } };
constexpr std::array kTetrahedronSides{ CellSide{ { 0, 1, 3 }, 3, 3 },
  CellSide{ { 1, 2, 3 }, 3, 2 }, CellSide{ { 0, 3, 2 }, 3, 1 }, CellSide{ { 0, 2, 1 }, 3, 0 } };
constexpr std::array kWedgeSides{ CellSide{ { 0, 1, 4, 3 }, 4, 0 },
  CellSide{ { 1, 2, 5, 4 }, 4, 2 }, CellSide{ { 0, 3, 5, 2 }, 4, 1 }, CellSide{ { 0, 2, 1 }, 3, 4 },
  CellSide{ { 3, 4, 5 }, 3, 3 } };
constexpr std::array kPyramidSides{ CellSide{ { 0, 1, 4 }, 3, 3 }, CellSide{ { 1, 2, 4 }, 3, 2 },
  CellSide{ { 2, 3, 4 }, 3, 4 }, CellSide{ { 0, 4, 3 }, 3, 1 }, CellSide{ { 0, 3, 2, 1 }, 4, 0 } };
constexpr std::array kTriangleSides{ CellSide{ { 0, 1 }, 2, 0 }, CellSide{ { 1, 2 }, 2, 2 },
  CellSide{ { 2, 0 }, 2, 1 } };
constexpr std::array kQuadrilateralSides{ CellSide{ { 0, 1 }, 2, 3 }, CellSide{ { 1, 2 }, 2, 2 },
  CellSide{ { 2, 3 }, 2, 4 }, CellSide{ { 3, 0 }, 2, 1 } };
} // namespace

std::optional<ExodusCell> ExodusCellOf(const std::string& type, int nodes)
{
  const auto* found = std::ranges::find_if(kElements,
    [&](const Element& element)
    { return type.starts_with(element.begin) && element.nodes == nodes; });
  return found == kElements.end() ? std::nullopt
                                  : std::optional(ExodusCell{ found->cell, found->order });
}

bool IsExodusSolid(const std::string& type)
{
  constexpr std::array kSolids{ "HEX", "TET", "WED", "PYR", "NFA" };
  return std::ranges::any_of(kSolids, [&](const char* begin) { return type.starts_with(begin); });
}

std::span<const CellSide> SidesOf(int cellType)
{
  switch (cellType)
  {
    case VTK_HEXAHEDRON:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
      return kHexahedronSides;
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TETRAHEDRON:
      return kTetrahedronSides;
    case VTK_WEDGE:
    case VTK_QUADRATIC_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
      return kWedgeSides;
    case VTK_PYRAMID:
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
    case VTK_LAGRANGE_PYRAMID:
      return kPyramidSides;
    case VTK_TRIANGLE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
      return kTriangleSides;
    case VTK_QUAD:
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
      return kQuadrilateralSides;
    default:
      return {};
  }
}
} // namespace pixelexact
