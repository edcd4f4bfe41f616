// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExodusCells_h
#define ExodusCells_h

#include <array>
#include <optional>
#include <span>
#include <string>

namespace pixelexact
{
/// The VTK cell of an Exodus element.
struct ExodusCell
{
  int type = 0; ///< VTK_...
  /// The element's node for each of the cell's nodes; empty: the orders are equal.
  std::span<const int> order;
};

/// The cell for a block's element type, upper case, and its number of nodes; none: elements without
/// a cell that has the same nodes.
std::optional<ExodusCell> ExodusCellOf(const std::string& type, int nodes);

/// Whether the elements are solids, of any number of nodes.
bool IsExodusSolid(const std::string& type);

/// A side of a cell: the face of a solid, or the edge of a plane element.
struct CellSide
{
  std::array<int, 4> corners; ///< places in the cell, which has its corners first
  int count = 0;              ///< of them
  int face = 0;               ///< as FacesOf(shape) counts
};

/// The sides of a VTK cell (linear, quadratic or Lagrange) in Exodus' order; empty for others.
std::span<const CellSide> SidesOf(int cellType);
} // namespace pixelexact
#endif
