// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Frame.h"
#include "Trace/Scene.h"

#include <array>
#include <mutex>
#include <span>
#include <vector>

namespace pixelexact
{
/// Pixels along a tile's side. A tile has some hundred hits per element and query, and there are
/// enough tiles for all cores.
inline constexpr int kTileSize = 32;

/// Samples of an image: (i, j) lies at image position (x0 + i step + offset, y0 + j step + offset)
/// and is the frame's sample (x0 + i step, y0 + j step) or, packed, (i, j).
struct SampleLattice
{
  double offset = 0.5; ///< 0.5: the pixels' centres, 0: their corners
  int x0 = 0;
  int y0 = 0;
  int step = 1;
  bool packed = false;
};

/// A rectangle of a sample lattice, or of pixels: [x0, x1) x [y0, y1).
struct TileArea
{
  int x0;
  int y0;
  int x1;
  int y1;

  [[nodiscard]] int Width() const { return x1 - x0; }
  [[nodiscard]] int Height() const { return y1 - y0; }
};

/// Image position in pixels; see Camera.
using ImagePosition = std::array<double, 2>;

/// The samples of a tile: their places in the image and in the buffers. Samples of a lattice are
/// ordered in blocks of 8 x 8 along a Z-curve, so that neighbours in memory are neighbours in the
/// image.
class TileSamples
{
public:
  /// Count of neighbouring samples of a lattice's row that follow each other in memory, except at
  /// the edges of the image.
  static constexpr int kRow = 8;

  /// Samples of a lattice, at most kTileSize + 1 in each direction; results go to rows of `width`
  /// samples.
  void Begin(const Camera& camera, const TileArea& area, const SampleLattice& lattice, int width);
  /// The samples of an area of the lattice with this offset; results go to buffers of the area
  /// alone.
  void BeginAlone(const Camera& camera, const TileArea& area, double offset);
  /// Samples at any positions; results of the i-th one go to place i. Neighbours should follow each
  /// other.
  void Begin(const Camera& camera, std::span<const ImagePosition> positions);

  /// Casts the samples' rays and finds their hits with all layers: hits[k] are those of layer k.
  /// Rays are cast in batches and not kept, so that they stay in the first-level cache. The scene
  /// may have no locator.
  void Meet(const Camera& camera, const Scene& scene, std::vector<HitSlots>& hits);

  [[nodiscard]] int Count() const { return Size; }

  std::vector<std::size_t> place; ///< in the buffers, by sample

private:
  /// Rays of a batch.
  static constexpr int kCast = 128;

  void Fit(int count);
  void Clip(const std::vector<KeptHalfSpace>& kept, int count);

  int Size = 0;
  std::vector<double> U;
  std::vector<double> V;
  std::array<std::array<double, kCast>, 3> Origin{};
  std::array<std::array<double, kCast>, 3> Direction{};
  std::array<double, kCast> Near{};
  std::array<double, kCast> Far{};
};

/// The sheets of a set of samples while tiles write to them: the nearest one, and those behind it,
/// which are allocated when the first ray reaches them.
class Sheets
{
public:
  /// The largest number of sheets; later sheets are discarded.
  static constexpr int kMax = 64;

  /// `nearest` is allocated for the buffers `wanted`; the other sheets get the same ones.
  Sheets(SampleBuffers& nearest, Buffer wanted)
    : Nearest(nearest)
    , Wanted(wanted)
  {
  }

  [[nodiscard]] Buffer Buffers() const { return Wanted; }

  /// Sheet k, from 0, the nearest, to kMax - 1. May be called from several threads at once.
  SampleBuffers& At(int k)
  {
    if (k == 0)
    {
      return Nearest;
    }
    const std::scoped_lock lock(Growing);
    auto& behind = Nearest.behind;
    // Sheets do not move while other threads write to them.
    behind.reserve(kMax - 1);
    while (behind.size() < static_cast<std::size_t>(k))
    {
      behind.emplace_back().Allocate(Wanted, Nearest.width, Nearest.height);
    }
    return behind[static_cast<std::size_t>(k) - 1];
  }

private:
  SampleBuffers& Nearest;
  Buffer Wanted;
  std::mutex Growing;
};

/// Finds all hits of the samples' rays, once, and walks each ray from hit to hit, in the order of
/// t, at equal t in the order of layers. Locates and evaluates the hits and writes them to the
/// sheets. After a hit outside the mesh the ray continues; after a hit on a translucent layer it
/// continues to the next sheet. Writes only the samples' own places; adds to `counters`. A sample's
/// result does not depend on other samples.
void TraceTile(const Scene& scene, const Camera& camera, TileSamples& samples, Sheets& sheets,
  FrameCounters& counters);
} // namespace pixelexact
