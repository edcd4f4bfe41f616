// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Contours/EdgeJudge.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pixelexact
{
/// Blocks of a tile's pixels on a flat surface, which are proven out together where all elements
/// that they may meet stay on one side of the values: no sample is needed. They lie where they lie
/// in the image, so that what is proven of a pixel does not depend on tiles.
class FlatBlocks
{
public:
  FlatBlocks(const Surface& surface, const Camera& camera, const TileArea& area);

  /// The tile's blocks on the surface; nothing where a ray does not meet it.
  [[nodiscard]] std::optional<Outline> Whole() const { return OutlineOf(Blocks); }

  /// For each pixel of the tile, row by row, whether it is still open.
  [[nodiscard]] std::vector<std::uint8_t> FindOpen(const EdgeJudge& judge) const;

private:
  [[nodiscard]] std::optional<Outline> OutlineOf(const TileArea& pixels) const;

  const Surface& TheSurface;
  const Camera& TheCamera;
  TileArea Area;
  TileArea Blocks; ///< of whole blocks
};
} // namespace pixelexact
