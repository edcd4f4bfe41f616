// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExodusCells_h
#define ExodusCells_h

#include <optional>
#include <span>
#include <string>

namespace pixelexact
{
/// The VTK cell of an Exodus element.
struct ExodusCell
{
  int type = 0; ///< VTK_...
  /// Which of the element's nodes is each of the cell's; empty: the orders are the same.
  std::span<const int> order;
};

/// The cell for a block's element type, upper case, and its number of nodes; none: elements without
/// a cell that has the same nodes.
std::optional<ExodusCell> ExodusCellOf(const std::string& type, int nodes);

/// Whether the elements are solids, of any number of nodes.
bool IsExodusSolid(const std::string& type);
} // namespace pixelexact
#endif
