// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Camera.h"
#include "Trace/Scene.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Pixels along a tile's side: some hundred hits per element and query, and tiles enough to keep
/// all cores busy.
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

/// In pixels; see Camera.
using ImagePosition = std::array<double, 2>;

/// The samples of a tile: where they lie in the image and where their results go. Those of a
/// lattice lie in blocks of 8 x 8 along a Z-curve, so that neighbours in memory are neighbours in
/// the image.
class TileSamples
{
public:
  /// Samples side by side in the lattice follow each other in memory at least this far, but at the
  /// edges of the image.
  static constexpr int kRow = 8;

  /// Samples of a lattice, at most kTileSize + 1 each way; results go to rows of `width` samples.
  void Begin(const Camera& camera, const TileArea& area, const SampleLattice& lattice, int width);
  /// Of the lattice with this offset, an area's samples, whose results go to rows of the area
  /// alone.
  void BeginAlone(const Camera& camera, const TileArea& area, double offset);
  /// Any samples; the i-th one's results go to place i. Neighbours should follow each other.
  void Begin(const Camera& camera, std::span<const ImagePosition> positions);

  /// The hits of all layers, by layer. Rays are cast a few at a time and not kept: what is known of
  /// them stays in the nearest cache.
  void Meet(const Camera& camera, const Scene& scene, std::vector<HitSlots>& hits);

  [[nodiscard]] int Count() const { return Size; }

  std::vector<std::size_t> place; ///< in the buffers

private:
  static constexpr int kSome = 128;

  void Fit(int count);
  void Clip(const std::vector<KeptHalfSpace>& kept, int count);
  [[nodiscard]] RayLanes Rays(int count) const;

  int Size = 0;
  std::vector<double> U;
  std::vector<double> V;
  std::array<std::array<double, kSome>, 3> Origin{};
  std::array<std::array<double, kSome>, 3> Direction{};
  std::array<double, kSome> Near{};
  std::array<double, kSome> Far{};
};
} // namespace pixelexact
