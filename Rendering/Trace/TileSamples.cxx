// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TileSamples.h"

#include "Trace/RayKernels.h"

#include <glm/common.hpp>

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
  // A power of two that holds a tile and the corners at its end.
  constexpr int kAcross = 2 * kTileSize / TileSamples::kRow;
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

/// By more than the rounding of positions on its faces.
Box3 Widened(const Box3& box)
{
  const Vec3 largest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  const Vec3 more = 1e-12 * (largest + (box.upper - box.lower));
  return { box.lower - more, box.upper + more };
}
} // namespace

void TileSamples::Fit(int count)
{
  Size = count;
  const auto needed = static_cast<std::size_t>(PaddedCount(count)) + kRow;
  if (U.size() < needed)
  {
    U.resize(needed);
    V.resize(needed);
    place.resize(needed);
  }
}

void TileSamples::Begin(
  const Camera& camera, const TileArea& area, const SampleLattice& lattice, int width)
{
  const int columns = area.Width();
  const int rows = area.Height();
  Fit(columns * rows);
  std::array<double, kTileSize + kRow> u{};
  std::array<double, kTileSize + kRow> v{};
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
  const auto placeOf = [&](int i, int j)
  {
    const int x = lattice.packed ? area.x0 + i : column(i);
    const int y = lattice.packed ? area.y0 + j : row(j);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
      static_cast<std::size_t>(x);
  };
  const auto step = static_cast<std::size_t>(lattice.packed ? 1 : lattice.step);
  std::size_t at = 0;
  // The first quarter holds the tiles without the corners at their ends.
  const bool whole = columns > kTileSize || rows > kTileSize;
  for (const Block& block : std::span(kBlocks).first(kBlocks.size() / (whole ? 1 : 4)))
  {
    const int inRow = std::min(kRow, columns - block.x);
    for (int y = block.y; inRow > 0 && y < std::min(block.y + kRow, rows); ++y)
    {
      // A whole row first, in arrays that nothing else points to; what is too much is overwritten.
      std::array<double, kRow> across;
      std::array<double, kRow> up;
      std::array<std::size_t, kRow> places;
      const std::size_t first = placeOf(block.x, y);
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

void TileSamples::BeginAlone(const Camera& camera, const TileArea& area, double offset)
{
  Begin(camera, area, { .offset = offset }, area.Width());
  const auto first = static_cast<std::size_t>(area.y0) * static_cast<std::size_t>(area.Width()) +
    static_cast<std::size_t>(area.x0);
  for (std::size_t& at : std::span(place).first(static_cast<std::size_t>(Size)))
  {
    at -= first;
  }
}

void TileSamples::Begin(const Camera& camera, std::span<const ImagePosition> positions)
{
  Fit(static_cast<int>(positions.size()));
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    U[i] = camera.U(positions[i][0]);
    V[i] = camera.V(positions[i][1]);
    place[i] = i;
  }
}

void TileSamples::Clip(const std::vector<KeptHalfSpace>& kept, int count)
{
  for (const auto& [a, b, c, d] : kept)
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
      const double at = a * Origin[0][i] + b * Origin[1][i] + c * Origin[2][i] + d;
      const double slope = a * Direction[0][i] + b * Direction[1][i] + c * Direction[2][i];
      const double t = -at / slope;
      if (slope > 0.0)
      {
        Near[i] = std::max(Near[i], t);
      }
      else if (slope < 0.0)
      {
        Far[i] = std::min(Far[i], t);
      }
      else if (!(at >= 0.0))
      {
        Near[i] = kNoHit;
      }
    }
  }
}

RayLanes TileSamples::Rays(int count) const
{
  return { { Origin[0].data(), Origin[1].data(), Origin[2].data() },
    { Direction[0].data(), Direction[1].data(), Direction[2].data() }, Near.data(), Far.data(),
    count };
}

void TileSamples::Meet(const Camera& camera, const Scene& scene, std::vector<HitSlots>& hits)
{
  hits.resize(std::max(hits.size(), scene.layers.size()));
  for (std::size_t k = 0; k < scene.layers.size(); ++k)
  {
    hits[k].Begin(Size);
  }
  // What lies outside of the mesh's box need not be found. A plane is met as fast as that is known.
  const bool isCurved = scene.locator != nullptr &&
    !std::ranges::all_of(scene.layers, [](const Layer& layer) { return layer.surface->IsFlat(); });
  const Box3 bounds = isCurved ? Widened(scene.locator->Bounds()) : Box3{};
  const bool clips = isCurved || !scene.kept.empty();
  double* const origin[3] = { Origin[0].data(), Origin[1].data(), Origin[2].data() };
  double* const direction[3] = { Direction[0].data(), Direction[1].data(), Direction[2].data() };
  const std::int64_t work = WorkOfRay(camera.Width(), camera.Height(), scene.layers.size());
  for (int first = 0; first < Size; first += kSome)
  {
    const int count = std::min(kSome, Size - first);
    const auto at = static_cast<std::size_t>(first);
    GetRayKernels().cast(camera.Rays(), &U[at], &V[at], count, origin, direction);
    if (first == 0 || clips)
    {
      Near.fill(kNearest);
      Far.fill(kFarthest);
      Clip(scene.kept, count);
    }
    if (isCurved)
    {
      GetRayKernels().clipToBox(bounds, origin, direction, count, Near.data(), Far.data());
    }
    for (std::size_t k = 0; k < scene.layers.size(); ++k)
    {
      const Layer& layer = scene.layers[k];
      RayLanes rays = Rays(count);
      rays.nearestOnly = layer.surface->IsOfMesh() && !layer.translucent;
      rays.work = work;
      hits[k].MoveTo(first);
      layer.surface->Meet(rays, hits[k]);
    }
  }
}
} // namespace pixelexact
