// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeJudge.h"
#include "Trace/Modules/ContourCertifier.h"
#include "Trace/TileVisit.h"

#include <memory>
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
  /// Of an edge.
  enum class State : std::uint8_t
  {
    Out,
    Undecided,
    In
  };
  /// Of an edge: what is still open.
  struct Part
  {
    std::size_t edge;
    EdgeEnd a;
    EdgeEnd b;
  };

  [[nodiscard]] EdgeEnd EndOf(
    const SampleBuffers& samples, std::size_t i, const ImagePosition& position) const;
  [[nodiscard]] SurfaceEdge EdgeBetween(const EdgeEnd& a, const EdgeEnd& b) const;
  [[nodiscard]] std::vector<int> ElementsNear() const;
  /// visit(a, b), of corners, in the order of Edges; endRow() after each row and column.
  template <class Visit, class EndRow>
  void ForEachEdge(const Visit& visit, const EndRow& endRow) const;
  /// Of all edges that show the layer.
  void LeaveOpen();
  [[nodiscard]] bool AreJoined(const EdgeEnd& a, const EdgeEnd& b) const;
  /// Of its ends that are on the layer; see EdgeJudge.
  [[nodiscard]] int SideOf(const Part& part) const;
  /// Whether the values of two elements lie on either side of one: it is between them even if none
  /// takes it.
  [[nodiscard]] bool MayJump(const Part& part) const;
  [[nodiscard]] EdgeFinding JudgeWithin(const Part& part) const;
  /// Consecutive edges of a row or a column.
  void SettleRun(std::span<const Part> run, std::vector<Part>& open);
  void SettlePart(const Part& part, int level, std::vector<Part>& open);
  void Settle(const Part& part, EdgeFinding finding, int level, std::vector<Part>& open);
  void Refine(std::vector<Part> parts);

  TileVisit& Tile;
  ContourMethod Method;
  std::vector<EdgeEnd> Corners;
  std::size_t Across;       ///< corners in a row
  std::size_t Up;           ///< corners in a column
  std::vector<State> Edges; ///< those across, row by row, then those up, column by column
  std::vector<int> Parts;   ///< open, of each edge
  ContourCounters Counted;
  const Surface* TheSurface = nullptr; ///< of the layer being judged
  int Layer = -1;
  const EdgeJudge* Judging = nullptr;
};
} // namespace pixelexact
