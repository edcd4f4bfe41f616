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
/// Classifies a tile's pixels on a flat surface in blocks: by the samples at pixels' centres, where
/// the frame holds them, and by the bounds of the elements there. Traces no samples.
class FlatBlocks
{
public:
  FlatBlocks(const LayerSight& sight, TileVisit& tile, std::optional<LatticePart> centres);

  /// No ray of the tile meets the surface in the mesh.
  [[nodiscard]] bool AreBeyond() { return IsBeyond(Area); }
  /// The tile's part of the surface; none if a ray does not meet it.
  [[nodiscard]] std::optional<Outline> Whole() { return OutlineOf(Area); }

  /// Verdicts of the tile's pixels, row by row. Undecided: the pixel is still open. Pixels with
  /// `asked` 0 are Out.
  [[nodiscard]] std::vector<ContourVerdict> Settle(
    const EdgeClassifier& classifier, std::span<const std::uint8_t> asked);

private:
  void Settle(const EdgeClassifier& classifier, const TileArea& block);
  /// Classifies a block by three of its centres, if they lie in one element: Out, Open, or
  /// Uncovered if the block is not proven to lie in one element. Decides single pixels of a small
  /// block that is Open.
  [[nodiscard]] EdgeFinding ClassifyInside(const EdgeClassifier& classifier, const TileArea& block);
  /// Decides a small block's pixels by the values at their corners and the error of these values.
  void SettlePixels(
    const EdgeClassifier& classifier, const TileArea& block, const PlanarValues& values);
  [[nodiscard]] bool IsOpen(const TileArea& block) const;
  void LeaveOut(const TileArea& block);
  /// All elements that the block may meet prove it Out.
  [[nodiscard]] bool IsOutAnyhow(const EdgeClassifier& classifier, const TileArea& block);
  [[nodiscard]] bool IsBeyond(const TileArea& pixels);
  [[nodiscard]] std::optional<Outline> OutlineOf(const TileArea& pixels);
  struct Corner
  {
    bool isKnown = false;
    bool meets = false; ///< as in EdgeEnd
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
  bool IsAhead = false;        ///< no block lies beyond the mesh
  bool ShowsAll;               ///< the surface is visible everywhere in the mesh
  std::vector<Corner> Corners; ///< met so far, while blocks are classified
  std::vector<ContourVerdict> States;
};
} // namespace pixelexact
