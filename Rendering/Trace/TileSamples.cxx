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
  // Arrays a multiple of 4096 bytes apart would drive each other out of the cache.
  constexpr std::size_t kApart = 5 * 8;
  const auto needed = static_cast<std::size_t>(PaddedCount(count)) + kApart;
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

void TileSamples::Begin(
  const Camera& camera, const TileArea& area, const SampleLattice& lattice, int width)
{
  const int columns = area.x1 - area.x0;
  const int rows = area.y1 - area.y0;
  Fit(columns * rows);
  std::array<double, kTileSize> u{};
  std::array<double, kTileSize> v{};
  const auto column = [&](int i) { return lattice.x0 + (area.x0 + i) * lattice.step; };
  const auto row = [&](int j) { return lattice.y0 + (area.y0 + j) * lattice.step; };
  for (int i = 0; i < columns; ++i)
  {
    u[static_cast<std::size_t>(i)] = camera.U(column(i) + lattice.offset);
  }
  for (int j = 0; j < rows; ++j)
  {
    v[static_cast<std::size_t>(j)] = camera.V(row(j) + lattice.offset);
  }
  const auto step = static_cast<std::size_t>(lattice.step);
  std::size_t at = 0;
  for (const Block& block : kBlocks)
  {
    const int inRow = std::min(kRow, columns - block.x);
    for (int y = block.y; inRow > 0 && y < std::min(block.y + kRow, rows); ++y)
    {
      // A whole row first, in arrays that nothing else points to; what is too much is overwritten.
      std::array<double, kRow> across;
      std::array<double, kRow> up;
      std::array<std::size_t, kRow> places;
      const std::size_t first = static_cast<std::size_t>(row(y)) * static_cast<std::size_t>(width) +
        static_cast<std::size_t>(column(block.x));
      for (std::size_t k = 0; k < kRow; ++k)
      {
        across[k] = u[static_cast<std::size_t>(block.x) + k];
        up[k] = v[static_cast<std::size_t>(y)];
        places[k] = first + k * step;
      }
      std::ranges::copy(across, &U[at]);
      std::ranges::copy(up, &V[at]);
      std::ranges::copy(places, &place[at]);
      at += static_cast<std::size_t>(inRow);
    }
  }
}

RayLanes TileSamples::CastSome(const Camera& camera, int first, int count, int to)
{
  std::array<double*, 6> column;
  for (int k = 0; k < 6; ++k)
  {
    column[static_cast<std::size_t>(k)] = Array(kOrigin + k) + to;
  }
  GetRayKernels().cast(camera.Rays(), &U[static_cast<std::size_t>(first)],
    &V[static_cast<std::size_t>(first)], count, column.data(), column.data() + 3);
  std::fill_n(Array(kTMin) + to, PaddedCount(count), 0.0);
  return { { column[0], column[1], column[2] }, { column[3], column[4], column[5] }, count };
}

void TileSamples::Cast(const Camera& camera)
{
  (void)CastSome(camera, 0, Size, 0);
}

void TileSamples::Meet(const Camera& camera, const Surface& met)
{
  constexpr int kSome = 128;
  const HitLanes all = Hits();
  for (int first = 0; first < Size; first += kSome)
  {
    const RayLanes rays = CastSome(camera, first, std::min(kSome, Size - first), 0);
    met.NextHit(rays, TMin(),
      { all.t + first,
        { all.position[0] + first, all.position[1] + first, all.position[2] + first } });
  }
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
