// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/FlatBlocks.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
/// Pixels along a side: of smaller ones the answers cost as much as their edges.
constexpr int kBlock = kTileSize;
} // namespace

FlatBlocks::FlatBlocks(const Surface& surface, const Camera& camera, const TileArea& area)
  : TheSurface(surface)
  , TheCamera(camera)
  , Area(area)
  , Blocks{ area.x0 / kBlock * kBlock, area.y0 / kBlock * kBlock,
    (area.x1 + kBlock - 1) / kBlock * kBlock, (area.y1 + kBlock - 1) / kBlock * kBlock }
{
}

std::optional<Outline> FlatBlocks::OutlineOf(const TileArea& pixels) const
{
  const std::array<ImagePosition, Outline::kMostCorners> places{
    { { 1.0 * pixels.x0, 1.0 * pixels.y0 }, { 1.0 * pixels.x1, 1.0 * pixels.y0 },
      { 1.0 * pixels.x1, 1.0 * pixels.y1 }, { 1.0 * pixels.x0, 1.0 * pixels.y1 } }
  };
  std::array<Vec3, Outline::kMostCorners> corners;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const std::vector<Hit> hits = HitsOf(TheSurface, TheCamera.At(places[k][0], places[k][1]));
    if (hits.empty())
    {
      return std::nullopt;
    }
    corners[k] = hits.front().position;
  }
  return Outline(corners);
}

std::vector<std::uint8_t> FlatBlocks::FindOpen(const EdgeJudge& judge) const
{
  std::vector<std::uint8_t> open(
    static_cast<std::size_t>(Area.Width()) * static_cast<std::size_t>(Area.Height()), 0);
  for (int y = Blocks.y0; y < Blocks.y1; y += kBlock)
  {
    for (int x = Blocks.x0; x < Blocks.x1; x += kBlock)
    {
      const std::optional<Outline> outline = OutlineOf({ x, y, x + kBlock, y + kBlock });
      if (outline && judge.StaysOnOne(*outline))
      {
        continue;
      }
      for (int row = std::max(y, Area.y0); row < std::min(y + kBlock, Area.y1); ++row)
      {
        const auto first = open.begin() + static_cast<std::ptrdiff_t>(row - Area.y0) * Area.Width();
        std::fill(first + (std::max(x, Area.x0) - Area.x0),
          first + (std::min(x + kBlock, Area.x1) - Area.x0), 1);
      }
    }
  }
  return open;
}
} // namespace pixelexact
