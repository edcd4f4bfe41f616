// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TileSamples.h"

#include "Trace/RayKernels.h"

#include <algorithm>
#include <array>

namespace pixelexact
{
namespace
{
struct Offset
{
  std::uint8_t x;
  std::uint8_t y;
};

/// Blocks of 8 x 8 along a Z-curve, row by row within.
constexpr auto MakeOrder()
{
  constexpr int kBlock = 8;
  constexpr int kBlocks = kTileSize / kBlock;
  std::array<Offset, static_cast<std::size_t>(kTileSize) * kTileSize> order{};
  std::size_t at = 0;
  for (int code = 0; code < kBlocks * kBlocks; ++code)
  {
    int blockX = 0;
    int blockY = 0;
    for (int bit = 0; (1 << bit) < kBlocks; ++bit)
    {
      blockX |= (code >> (2 * bit) & 1) << bit;
      blockY |= (code >> (2 * bit + 1) & 1) << bit;
    }
    for (int i = 0; i < kBlock * kBlock; ++i)
    {
      order[at++] = { static_cast<std::uint8_t>(blockX * kBlock + i % kBlock),
        static_cast<std::uint8_t>(blockY * kBlock + i / kBlock) };
    }
  }
  return order;
}
constexpr auto kOrder = MakeOrder();
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
  std::array<double, kTileSize> u{};
  std::array<double, kTileSize> v{};
  for (int i = 0; i < area.x1 - area.x0; ++i)
  {
    u[static_cast<std::size_t>(i)] = camera.U(area.x0 + i + offset);
  }
  for (int j = 0; j < area.y1 - area.y0; ++j)
  {
    v[static_cast<std::size_t>(j)] = camera.V(area.y0 + j + offset);
  }
  std::size_t at = 0;
  for (const auto& [x, y] : kOrder)
  {
    if (area.x0 + x < area.x1 && area.y0 + y < area.y1)
    {
      place[at] = static_cast<std::size_t>(area.y0 + y) * static_cast<std::size_t>(width) +
        static_cast<std::size_t>(area.x0 + x);
      U[at] = u[x];
      V[at++] = v[y];
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
