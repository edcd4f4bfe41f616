// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/Contours/FlatBlocks.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
constexpr int kLargest = kTileSize;
/// Smaller ones cost more than their edges.
constexpr int kSmallest = 16;
} // namespace

FlatBlocks::FlatBlocks(const Surface& surface, const Camera& camera, const TileArea& area)
  : TheSurface(surface)
  , TheCamera(camera)
  , Area(area)
  , Blocks{ area.x0 / kLargest * kLargest, area.y0 / kLargest * kLargest,
    (area.x1 + kLargest - 1) / kLargest * kLargest, (area.y1 + kLargest - 1) / kLargest * kLargest }
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
  for (int y = Blocks.y0; y < Blocks.y1; y += kLargest)
  {
    for (int x = Blocks.x0; x < Blocks.x1; x += kLargest)
    {
      Find(judge, judge.All(), x, y, kLargest, open);
    }
  }
  return open;
}

void FlatBlocks::Find(const EdgeJudge& judge, const EdgeJudge::Nearby& nearby, int x, int y,
  int size, std::vector<std::uint8_t>& open) const
{
  const TileArea own{ std::max(x, Area.x0), std::max(y, Area.y0), std::min(x + size, Area.x1),
    std::min(y + size, Area.y1) };
  if (own.Width() <= 0 || own.Height() <= 0)
  {
    return;
  }
  const std::optional<Outline> outline = OutlineOf({ x, y, x + size, y + size });
  const EdgeJudge::Nearby here = outline ? judge.Narrow(nearby, *outline) : nearby;
  if (outline && here.open.empty())
  {
    return;
  }
  if (size > kSmallest)
  {
    const int half = size / 2;
    for (const int dy : { 0, half })
    {
      for (const int dx : { 0, half })
      {
        Find(judge, here, x + dx, y + dy, half, open);
      }
    }
    return;
  }
  for (int row = own.y0; row < own.y1; ++row)
  {
    const auto first = open.begin() + static_cast<std::ptrdiff_t>(row - Area.y0) * Area.Width();
    std::fill(first + (own.x0 - Area.x0), first + (own.x1 - Area.x0), 1);
  }
}
} // namespace pixelexact
