// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeRefiner.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/TileVisit.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pixelexact
{
/// A layer with contours: its iso-values and the bounds of its field.
struct ContouredLayer
{
  int number = 0;
  std::span<const double> values; ///< in ascending order
  const LayerBounds* bounds = nullptr;
};

/// The ends of edges at a tile's corners. A corner without an entry shows no layer.
class TileCorners
{
public:
  explicit TileCorners(std::size_t count)
    : Places(count, 0)
    , Ends(1)
  {
  }

  void Set(std::size_t corner, const EdgeEnd& end)
  {
    Places[corner] = Ends.size();
    Ends.push_back(end);
  }
  [[nodiscard]] const EdgeEnd& operator[](std::size_t corner) const { return Ends[Places[corner]]; }
  [[nodiscard]] std::size_t Size() const { return Places.size(); }

private:
  std::vector<std::size_t> Places;
  std::vector<EdgeEnd> Ends;
};

/// Classifies one tile's pixels; see Documentation/contours-proof.md.
class ContourTile
{
public:
  ContourTile(TileVisit& tile, const ContourMethod& method);
  /// Second pass over a tile with the verdicts `before`, row by row: keeps decided pixels and
  /// re-classifies the Undecided ones. Traces the tile's centres if the frame does not hold them.
  ContourTile(TileVisit& tile, const ContourMethod& method, std::vector<ContourVerdict> before);

  /// Joins the verdicts for one layer's iso-values with the tile's verdicts.
  void Classify(const ContouredLayer& layer, EdgeWork& work);
  /// A ContourVerdict for each pixel of the tile, row by row.
  [[nodiscard]] std::span<const ContourVerdict> Verdicts() const { return Pixels; }
  [[nodiscard]] const ContourCounters& Counters() const { return Counted; }
  /// 1 for a classified pixel whose corners all lie on a plateau of one layer
  /// (EdgeClassifier::IsOnPlateau), row by row.
  [[nodiscard]] std::span<const std::uint8_t> Plateaus() const { return OnPlateau; }

private:
  /// The samples at the tile's pixel centres: those of the frame, or, in a second pass, traced
  /// ones.
  [[nodiscard]] std::optional<LatticePart> Centres();
  /// Traces the corners of open pixels.
  [[nodiscard]] TileCorners EndsOf(const LayerSight& sight, std::span<const std::uint8_t> open);
  /// 1 for each corner that shows the layer, in a lattice of (Across + 2) x (Up + 2) that includes
  /// one ring around the tile. Of the ring, only corners inside the frame and beside edges with no
  /// end on the layer are traced.
  [[nodiscard]] std::vector<std::uint8_t> ShownAround(
    const LayerSight& sight, const TileCorners& corners);
  /// Calls visit(edge, a, b) with the corner numbers of each edge of an open pixel, in the order of
  /// `edges` in ClassifyEdges, and endRow() where a row or column of them ends.
  template <class Visit, class EndRow>
  void ForEachEdge(
    std::span<const std::uint8_t> open, const Visit& visit, const EndRow& endRow) const;
  /// Makes the pixels at edges with an end on the layer Undecided.
  void LeaveOpen(int layer);
  /// The value of the layer's field if it is the same on all of the layer's surface.
  [[nodiscard]] std::optional<double> HeldBy(
    const Surface& surface, const ContouredLayer& layer) const;
  void ClassifyEdges(LayerSight& sight, const EdgeClassifier& classifier,
    std::span<const std::uint8_t> open, EdgeWork& work);
  /// Joins the verdicts of each pixel's four edges. Horizontal edges come first, row by row, then
  /// vertical ones, column by column.
  [[nodiscard]] std::vector<ContourVerdict> StatesOf(
    std::span<const ContourVerdict> edges, std::span<const std::uint8_t> open) const;
  /// Counts the pixels that whole edges decided and those that subdivided edges decided.
  void CountStages(std::span<const ContourVerdict> unsplit, std::span<const ContourVerdict> states,
    std::span<const std::uint8_t> open);
  /// Classifies the inside of pixels that are Out by their edges.
  void ClassifyInteriors(LayerSight& sight, const EdgeClassifier& classifier,
    const TileCorners& corners, std::span<const std::uint8_t> open,
    std::span<ContourVerdict> states);
  void MarkPlateaus(const LayerSight& sight, const EdgeClassifier& classifier,
    const TileCorners& corners, std::span<const ContourVerdict> states);
  void Add(std::span<const ContourVerdict> states);
  [[nodiscard]] std::size_t CountEdges() const { return (Across - 1) * Up + Across * (Up - 1); }

  TileVisit& Tile;
  ContourMethod Method;
  bool Again = false;
  std::size_t Across; ///< corners in a row
  std::size_t Up;     ///< corners in a column
  std::vector<ContourVerdict> Pixels;
  std::vector<std::uint8_t> Asked; ///< 1: the pixel is to be classified
  std::vector<std::uint8_t> OnPlateau;
  ContourCounters Counted;
  SampleBuffers Traced; ///< centres that the frame does not hold
};
} // namespace pixelexact
