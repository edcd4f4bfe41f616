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
/// What certifies the contours of a layer: its iso-values and what is known of its field.
struct ContouredLayer
{
  int number = 0;
  std::span<const double> values; ///< in ascending order
  const LayerBounds* bounds = nullptr;
};

/// Those of a tile's corners that are asked for; the others see nothing.
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

/// The verdicts of one tile's pixels; see Documentation/contours-proof.md.
class ContourTile
{
public:
  ContourTile(TileVisit& tile, const ContourMethod& method);
  /// Of one that is visited again: as its pixels were found then, of which those that are Undecided
  /// are judged anew. Its centres are traced where they are not at hand.
  ContourTile(TileVisit& tile, const ContourMethod& method, std::vector<ContourVerdict> before);

  /// Adds the findings of a layer's values to those of the tile's pixels.
  void Classify(const ContouredLayer& layer, EdgeWork& work);
  /// A ContourVerdict for each pixel of the tile, row by row.
  [[nodiscard]] std::span<const ContourVerdict> Verdicts() const { return Pixels; }
  [[nodiscard]] const ContourCounters& Counters() const { return Counted; }
  /// 1: of a judged pixel whose corners all lie on a plateau of one layer
  /// (EdgeClassifier::IsOnPlateau).
  [[nodiscard]] std::span<const std::uint8_t> Plateaus() const { return OnPlateau; }

private:
  /// The centres of its pixels, as `Tile` has them; of one that is visited again, or traced.
  [[nodiscard]] std::optional<LatticePart> Centres();
  /// Of the corners of open pixels, row by row.
  [[nodiscard]] TileCorners EndsOf(const LayerSight& sight, std::span<const std::uint8_t> open);
  /// Which corners show the layer, (Across + 2) x (Up + 2): of those around the tile, none of them
  /// beyond the frame, the ones beside edges whose ends do not.
  [[nodiscard]] std::vector<std::uint8_t> ShownAround(
    const LayerSight& sight, const TileCorners& corners);
  /// visit(edge, a, b) of corners, for the edges of open pixels, in the order of `edges` in
  /// ClassifyEdges; endRow() where rows and columns of them end.
  template <class Visit, class EndRow>
  void ForEachEdge(
    std::span<const std::uint8_t> open, const Visit& visit, const EndRow& endRow) const;
  /// Of those that show the layer.
  void LeaveOpen(int layer);
  /// The value of the layer's field on all of its surface, where there is one.
  [[nodiscard]] std::optional<double> HeldBy(
    const Surface& surface, const ContouredLayer& layer) const;
  void ClassifyEdges(LayerSight& sight, const EdgeClassifier& classifier,
    std::span<const std::uint8_t> open, EdgeWork& work);
  /// Of pixels by those of their edges: across, row by row, then up, column by column.
  [[nodiscard]] std::vector<ContourVerdict> StatesOf(
    std::span<const ContourVerdict> edges, std::span<const std::uint8_t> open) const;
  /// By what those that were open are settled.
  void CountStages(std::span<const ContourVerdict> unsplit, std::span<const ContourVerdict> states,
    std::span<const std::uint8_t> open);
  /// Looks inside of those that are out.
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
  std::vector<std::uint8_t> Asked; ///< 1: of a pixel that is judged
  std::vector<std::uint8_t> OnPlateau;
  ContourCounters Counted;
  SampleBuffers Traced; ///< centres that were not at hand
};
} // namespace pixelexact
