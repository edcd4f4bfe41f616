// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeSettler.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/TileVisit.h"

#include <span>
#include <vector>

namespace pixelexact
{
/// What certifies the contours of a layer: its iso-values and what is known of its field.
struct ContouredLayer
{
  int number = 0;
  std::span<const double> values; ///< in ascending order
  const LayerBounds* bounds = nullptr;
};

/// The verdicts of one tile's pixels; see Documentation/contours.md.
class ContourTile
{
public:
  ContourTile(TileVisit& tile, const ContourMethod& method);

  /// Adds the findings of a layer's values to those of the tile's edges.
  void Judge(const ContouredLayer& layer);
  /// A ContourVerdict for each pixel of the tile, row by row.
  void Tell(std::span<std::uint8_t> verdicts) const;
  [[nodiscard]] const ContourCounters& Counters() const { return Counted; }

private:
  /// Of all corners, row by row.
  [[nodiscard]] std::vector<EdgeEnd> EndsOf(const LayerSight& sight);
  /// Whose boxes meet the tile's part of a flat surface.
  [[nodiscard]] std::vector<int> ElementsNear(std::span<const EdgeEnd> corners) const;
  /// visit(edge, a, b), of corners, in the order of Edges; endRow() after each row and column.
  template <class Visit, class EndRow>
  void ForEachEdge(const Visit& visit, const EndRow& endRow) const;
  /// All edges that show the layer.
  void LeaveOpen(int layer);

  TileVisit& Tile;
  ContourMethod Method;
  std::size_t Across;           ///< corners in a row
  std::size_t Up;               ///< corners in a column
  std::vector<EdgeState> Edges; ///< those across, row by row, then those up, column by column
  ContourCounters Counted;
};
} // namespace pixelexact
