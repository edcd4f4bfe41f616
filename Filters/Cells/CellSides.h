// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellSides_h
#define CellSides_h

#include <array>
#include <span>

namespace pixelexact
{
/// A side of a cell: the face of a solid, or the edge of a plane element.
struct CellSide
{
  std::array<int, 4> corners; ///< places in the cell, which has its corners first
  int count = 0;              ///< of them
  int face = 0;               ///< as FacesOf(shape) counts
};

/// Those of a VTK cell, linear, quadratic or Lagrange, in Exodus' order; none of others.
std::span<const CellSide> SidesOf(int cellType);
} // namespace pixelexact
#endif
