// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeClassifier.h"
#include "Trace/Contours/EdgeRefiner.h"
#include "Trace/Contours/LayerSight.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pixelexact
{
/// A tile's pixels on a flat surface that are proven out by blocks, or in, by what is seen at the
/// pixels' centres, where there are some, and what is known of the elements there: no other samples
/// are needed.
class FlatBlocks
{
public:
  FlatBlocks(const LayerSight& sight, TileVisit& tile, std::optional<LatticePart> centres);

  /// Whether no ray of the tile meets it in the mesh.
  [[nodiscard]] bool AreBeyond() { return IsBeyond(Area); }
  /// The tile's part of the surface; nothing where a ray does not meet it.
  [[nodiscard]] std::optional<Outline> Whole() { return OutlineOf(Area); }

  /// For each pixel of the tile, row by row; Undecided: it is still open. Of those that are not
  /// asked for (0): Out.
  [[nodiscard]] std::vector<ContourVerdict> Settle(
    const EdgeClassifier& classifier, std::span<const std::uint8_t> asked);

private:
  void Settle(const EdgeClassifier& classifier, const TileArea& block);
  /// By three of its centres, if they are in one element: Out, Open, or Uncovered where the block
  /// is not proven to lie in one element. Of a small block that is open, pixels
  /// may be settled.
  [[nodiscard]] EdgeFinding ClassifyInside(const EdgeClassifier& classifier, const TileArea& block);
  /// Pixels by the values at their corners, known up to an error.
  void SettlePixels(
    const EdgeClassifier& classifier, const TileArea& block, const PlanarValues& values);
  [[nodiscard]] bool IsOpen(const TileArea& block) const;
  void LeaveOut(const TileArea& block);
  /// By all elements that it may meet.
  [[nodiscard]] bool IsOutAnyhow(const EdgeClassifier& classifier, const TileArea& block);
  [[nodiscard]] bool IsBeyond(const TileArea& pixels);
  [[nodiscard]] std::optional<Outline> OutlineOf(const TileArea& pixels);
  struct Corner
  {
    bool isKnown = false;
    bool meets = false; ///< as of EdgeEnd
    bool isAhead = false;
    Vec3 x{ 0.0 };
  };
  [[nodiscard]] Corner CornerAt(int x, int y);
  [[nodiscard]] std::array<Corner, Outline::kMaxCorners> CornersOf(const TileArea& pixels);
  [[nodiscard]] bool ShowsAt(int x, int y) const
  {
    return Centres && Sight.ShowsAt(Centres->samples, Centres->At(x, y));
  }
  [[nodiscard]] EdgeEnd EndAt(int x, int y) const;
  [[nodiscard]] std::size_t PixelAt(int x, int y) const
  {
    return static_cast<std::size_t>(y - Area.y0) * static_cast<std::size_t>(Area.Width()) +
      static_cast<std::size_t>(x - Area.x0);
  }

  const LayerSight& Sight;
  std::optional<LatticePart> Centres;
  TileArea Area;
  bool IsAhead = false;        ///< no block is beyond
  bool ShowsAll;               ///< whatever is on the surface in the mesh: nothing hides it
  std::vector<Corner> Corners; ///< that are known, while blocks are settled
  std::vector<ContourVerdict> States;
};
} // namespace pixelexact
