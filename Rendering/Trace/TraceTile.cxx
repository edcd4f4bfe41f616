// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/TraceTile.h"

#include "Core/Base/CheckedOut.h"
#include "Core/Base/StageClock.h"
#include "Trace/RayKernels.h"
#include "Trace/TileHits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>

// The stages of a tile's rays, in this order: samples are placed; rays are cast, intersected with
// the surfaces, and walked from hit to hit; hits are evaluated (TileHits) and written.

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
  // A power of two that covers a tile and the corners at its end.
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

/// The box, enlarged by more than the rounding of positions on its faces.
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
  std::array<std::size_t, kTileSize + kRow> placeOfColumn{};
  std::array<std::size_t, kTileSize + kRow> placeOfRow{};
  for (int i = 0; i < columns; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    const int column = lattice.x0 + (area.x0 + i) * lattice.step;
    u[at] = camera.U(column + lattice.offset);
    placeOfColumn[at] = static_cast<std::size_t>(lattice.packed ? area.x0 + i : column);
  }
  for (int j = 0; j < rows; ++j)
  {
    const auto at = static_cast<std::size_t>(j);
    const int row = lattice.y0 + (area.y0 + j) * lattice.step;
    v[at] = camera.V(row + lattice.offset);
    placeOfRow[at] = static_cast<std::size_t>(lattice.packed ? area.y0 + j : row) *
      static_cast<std::size_t>(width);
  }
  std::size_t at = 0;
  // The first quarter covers tiles without the corners at their ends.
  const bool whole = columns > kTileSize || rows > kTileSize;
  for (const Block& block : std::span(kBlocks).first(kBlocks.size() / (whole ? 1 : 4)))
  {
    const int inRow = std::min(kRow, columns - block.x);
    for (int y = block.y; inRow > 0 && y < std::min(block.y + kRow, rows); ++y)
    {
      // Whole rows are written to local arrays without aliases; the surplus is overwritten.
      std::array<double, kRow> across;
      std::array<double, kRow> up;
      std::array<std::size_t, kRow> places;
      for (std::size_t k = 0; k < kRow; ++k)
      {
        across[k] = u[static_cast<std::size_t>(block.x) + k];
        up[k] = v[static_cast<std::size_t>(y)];
        places[k] = placeOfRow[static_cast<std::size_t>(y)] +
          placeOfColumn[static_cast<std::size_t>(block.x) + k];
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
  Begin(camera, { 0, 0, area.Width(), area.Height() },
    { .offset = offset, .x0 = area.x0, .y0 = area.y0, .packed = true }, area.Width());
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

void TileSamples::Meet(const Camera& camera, const Scene& scene, std::vector<HitSlots>& hits)
{
  hits.resize(std::max(hits.size(), scene.layers.size()));
  for (std::size_t k = 0; k < scene.layers.size(); ++k)
  {
    hits[k].Begin(Size);
  }
  // Hits outside the mesh's box are not needed. Clipping would cost as much as meeting a plane.
  const bool isCurved = scene.locator != nullptr &&
    !std::ranges::all_of(scene.layers, [](const Layer& layer) { return layer.surface->IsFlat(); });
  const Box3 bounds = isCurved ? Widened(scene.locator->Bounds()) : Box3{};
  const bool clips = isCurved || !scene.kept.empty();
  double* const origin[3] = { Origin[0].data(), Origin[1].data(), Origin[2].data() };
  double* const direction[3] = { Direction[0].data(), Direction[1].data(), Direction[2].data() };
  const std::int64_t work = WorkOfRay(camera.Width(), camera.Height(), scene.layers.size());
  for (int first = 0; first < Size; first += kCast)
  {
    const int count = std::min(kCast, Size - first);
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
      const RayLanes rays{ { origin[0], origin[1], origin[2] },
        { direction[0], direction[1], direction[2] }, Near.data(), Far.data(), count,
        layer.surface->IsOfMesh() && !layer.translucent, work };
      hits[k].MoveTo(first);
      layer.surface->Meet(rays, hits[k]);
    }
  }
}

//--- Walk, evaluate, write ---

namespace
{
/// The hits of one layer that rays have reached.
struct ReachedHits
{
  std::vector<int> ray; ///< ascending
  std::vector<int> slot;
};

/// The arrays of a tile.
struct TileArrays
{
  std::vector<HitSlots> hits;       ///< by layer
  std::vector<int> alive;           ///< rays that continue, ascending
  std::vector<int> passed;          ///< slots passed, by layer and ray; only for several layers
  std::vector<ReachedHits> reached; ///< by layer
  std::vector<int> depth;           ///< sheets passed, by ray; empty if all layers are opaque
  TileHits batch;
};

/// One call of TraceTile.
class TileWalk
{
public:
  TileWalk(const Scene& scene, TileSamples& samples, Sheets& sheets, FrameCounters& counters)
    : Traced(scene)
    , Samples(samples)
    , ToSheets(sheets)
    , Counters(counters)
    , Rays(static_cast<std::size_t>(samples.Count()))
    , Place(std::span(samples.place).first(Rays))
    , Translucent(HasTranslucent(scene))
    , Arrays(*Kept)
  {
  }

  void Run(const Camera& camera)
  {
    {
      const StageScope scope(Stage::Rays);
      Samples.Meet(camera, Traced, Arrays.hits);
    }
    Counters.rays += Samples.Count();
    Arrays.depth.assign(Translucent ? Rays : 0, 0);
    Arrays.reached.resize(std::max(Arrays.reached.size(), Traced.layers.size()));
    if (Traced.layers.size() == 1)
    {
      WalkOneLayer();
    }
    else
    {
      WalkLayers();
    }
  }

private:
  /// Walks rays on a scene of one layer: the k-th hits are those of slot k.
  void WalkOneLayer()
  {
    const HitSlots& hits = Arrays.hits[0];
    int slot = 0;
    if (hits.Count() > 0 &&
      GetRayKernels().countHits(hits.T(0), Samples.Count()) == Samples.Count())
    {
      // Every ray meets the surface, so nothing is gathered.
      Arrays.batch.TakeFirstSlot(HitsWith(0), Place);
      EvaluateAndWrite();
      if (hits.Count() == 1)
      {
        return;
      }
      Arrays.alive.clear();
      KeepGoing();
      slot = 1;
    }
    else
    {
      AllAreAlive();
    }
    ReachedHits& reached = Arrays.reached[0];
    for (; slot < hits.Count() && !Arrays.alive.empty(); ++slot)
    {
      reached.ray.clear();
      const double* const t = hits.T(slot);
      std::ranges::copy_if(
        Arrays.alive, std::back_inserter(reached.ray), [t](int ray) { return t[ray] < kNoHit; });
      reached.slot.assign(reached.ray.size(), slot);
      Arrays.alive.clear();
      FinishReached(0);
    }
  }

  void WalkLayers()
  {
    const std::size_t layers = Traced.layers.size();
    AllAreAlive();
    Arrays.passed.assign(layers * Rays, 0);
    while (!Arrays.alive.empty())
    {
      for (std::size_t k = 0; k < layers; ++k)
      {
        Arrays.reached[k].ray.clear();
        Arrays.reached[k].slot.clear();
      }
      for (const int ray : Arrays.alive)
      {
        Advance(ray);
      }
      Arrays.alive.clear();
      for (std::size_t k = 0; k < layers; ++k)
      {
        FinishReached(k);
      }
      // SampleWriter needs neighbours next to each other.
      std::ranges::sort(Arrays.alive);
    }
  }

  void AllAreAlive()
  {
    Arrays.alive.resize(Rays);
    std::iota(Arrays.alive.begin(), Arrays.alive.end(), 0);
  }

  /// Advances a ray to its nearest hit that it has not passed; at equal t, to the first layer's.
  void Advance(int ray)
  {
    const auto at = static_cast<std::size_t>(ray);
    double nearest = kNoHit;
    std::size_t layer = 0;
    for (std::size_t k = 0; k < Traced.layers.size(); ++k)
    {
      const int slot = Arrays.passed[k * Rays + at];
      if (slot < Arrays.hits[k].Count() && Arrays.hits[k].T(slot)[ray] < nearest)
      {
        nearest = Arrays.hits[k].T(slot)[ray];
        layer = k;
      }
    }
    if (nearest < kNoHit)
    {
      Arrays.reached[layer].ray.push_back(ray);
      Arrays.reached[layer].slot.push_back(Arrays.passed[layer * Rays + at]++);
    }
  }

  [[nodiscard]] TileHits::Source HitsWith(std::size_t layer) const
  {
    return { Traced.layers[layer], static_cast<std::uint8_t>(layer), Arrays.hits[layer] };
  }

  /// Evaluates and writes a layer's hits that rays have reached.
  void FinishReached(std::size_t layer)
  {
    const ReachedHits& reached = Arrays.reached[layer];
    if (!reached.ray.empty())
    {
      Arrays.batch.Gather(HitsWith(layer), reached.ray, reached.slot, Place);
      EvaluateAndWrite();
      KeepGoing();
    }
  }

  void EvaluateAndWrite()
  {
    Counters.surfaceHits += static_cast<std::int64_t>(Arrays.batch.Size());
    Arrays.batch.Evaluate(*Traced.locator, ToSheets.At(0), Counters.floatCheck);
    Arrays.batch.Write(*Traced.locator, Arrays.depth, ToSheets, Counters);
  }

  /// Adds the batch's rays that do not end at their hits to `alive`.
  void KeepGoing()
  {
    const TileHits& batch = Arrays.batch;
    const std::span<const Verdict> verdicts = batch.Verdicts();
    for (std::size_t i = 0; i < batch.Size(); ++i)
    {
      const int ray = batch.RayOf(i);
      const auto at = static_cast<std::size_t>(ray);
      if (verdicts[i] == Verdict::Outside)
      {
        Arrays.alive.push_back(ray);
      }
      else if (Translucent && Arrays.depth[at] == Sheets::kMax)
      {
        ++Counters.cutOff;
      }
      else if (batch.GetLayer().translucent)
      {
        ++Arrays.depth[at];
        Arrays.alive.push_back(ray);
      }
    }
  }

  const Scene& Traced;
  TileSamples& Samples;
  Sheets& ToSheets;
  FrameCounters& Counters;
  std::size_t Rays;
  std::span<const std::size_t> Place;
  bool Translucent;
  CheckedOut<TileArrays> Kept;
  TileArrays& Arrays;
};
} // namespace

void TraceTile(const Scene& scene, const Camera& camera, TileSamples& samples, Sheets& sheets,
  FrameCounters& counters)
{
  TileWalk(scene, samples, sheets, counters).Run(camera);
}
} // namespace pixelexact
