// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TileSamples.h"

#include "Trace/RayKernels.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
struct Block
{
  int x;
  int y;
};

/// Blocks of kRow x kRow samples along a Z-curve.
constexpr auto MakeBlocks()
{
  constexpr int kAcross = kTileSize / TileSamples::kRow;
  std::array<Block, static_cast<std::size_t>(kAcross) * kAcross> blocks{};
  for (int code = 0; code < kAcross * kAcross; ++code)
  {
    Block& block = blocks[static_cast<std::size_t>(code)];
    for (int bit = 0; (1 << bit) < kAcross; ++bit)
    {
      block.x |= (code >> (2 * bit) & 1) << bit;
      block.y |= (code >> (2 * bit + 1) & 1) << bit;
    }
    block.x *= TileSamples::kRow;
    block.y *= TileSamples::kRow;
  }
  return blocks;
}
constexpr auto kBlocks = MakeBlocks();
} // namespace

void TileSamples::Fit(int count)
{
  Size = count;
  const auto needed = static_cast<std::size_t>(PaddedCount(count));
  if (Stride < needed)
  {
    Stride = needed;
    Columns.resize(static_cast<std::size_t>(kColumns) * Stride);
    U.resize(Stride);
    V.resize(Stride);
    place.resize(Stride);
    surface.resize(Stride);
  }
}

void TileSamples::Cast(const Camera& camera, const TileArea& area, double offset, int width)
{
  Fit((area.x1 - area.x0) * (area.y1 - area.y0));
  const int columns = area.x1 - area.x0;
  const int rows = area.y1 - area.y0;
  std::array<double, kTileSize> u{};
  for (int i = 0; i < columns; ++i)
  {
    u[static_cast<std::size_t>(i)] = camera.U(area.x0 + i + offset);
  }
  std::size_t at = 0;
  for (const Block& block : kBlocks)
  {
    const int inRow = std::min(kRow, columns - block.x);
    for (int y = block.y; inRow > 0 && y < std::min(block.y + kRow, rows); ++y)
    {
      const double v = camera.V(area.y0 + y + offset);
      const std::size_t first =
        static_cast<std::size_t>(area.y0 + y) * static_cast<std::size_t>(width) +
        static_cast<std::size_t>(area.x0 + block.x);
      const double* fromU = &u[static_cast<std::size_t>(block.x)];
      for (int k = 0; k < inRow; ++k, ++at)
      {
        place[at] = first + static_cast<std::size_t>(k);
        U[at] = fromU[k];
        V[at] = v;
      }
    }
  }
  std::fill_n(Array(kTMin), PaddedCount(Size), 0.0);
  double* const origin[3] = { Array(kOrigin), Array(kOrigin + 1), Array(kOrigin + 2) };
  double* const direction[3] = { Array(kDirection), Array(kDirection + 1), Array(kDirection + 2) };
  GetRayKernels().cast(camera.Rays(), U.data(), V.data(), Size, origin, direction);
}

RayLanes TileSamples::Rays() const
{
  return { { Array(kOrigin), Array(kOrigin + 1), Array(kOrigin + 2) },
    { Array(kDirection), Array(kDirection + 1), Array(kDirection + 2) }, Size };
}

HitLanes TileSamples::HitsAt(int column)
{
  return { Array(column), { Array(column + 1), Array(column + 2), Array(column + 3) } };
}

LanePoints TileSamples::Positions() const
{
  return { { Array(kPosition), Array(kPosition + 1), Array(kPosition + 2) }, Size };
}

Vec3 TileSamples::Position(int i) const
{
  return { Array(kPosition)[i], Array(kPosition + 1)[i], Array(kPosition + 2)[i] };
}
} // namespace pixelexact
