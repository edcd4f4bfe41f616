// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surface.h"
#include "Trace/Tile.h"

#include <vector>

namespace pixelexact
{
/// The samples of a tile that are still on their way, coordinate by coordinate: ray, place in the
/// frame, and the hit at hand. Samples lie in blocks of 8 x 8 along a Z-curve, so that neighbours
/// in memory are neighbours in the image.
class TileSamples
{
public:
  /// Samples side by side in the lattice follow each other in memory at least this far, but at the
  /// edges of the image.
  static constexpr int kRow = 8;

  /// The samples of a tile, without their rays; see TraceTile.
  void Begin(const Camera& camera, const TileArea& area, const SampleLattice& lattice, int width);
  /// All rays.
  void Cast(const Camera& camera);
  /// The nearest hits of all rays, which are cast a few at a time and not kept: what is known of
  /// them stays in the nearest cache.
  void Meet(const Camera& camera, const Surface& met);
  /// Keeps the samples for which `keep(i)`, in order.
  template <class Keep>
  void Filter(const Keep& keep);

  [[nodiscard]] int Count() const { return Size; }
  [[nodiscard]] RayLanes Rays() const;
  [[nodiscard]] HitLanes Hits() { return HitsAt(kT); }
  /// Room for the hits of another surface.
  [[nodiscard]] HitLanes OtherHits() { return HitsAt(kOtherT); }
  [[nodiscard]] LanePoints Positions() const;
  [[nodiscard]] Vec3 Position(int i) const;
  [[nodiscard]] double* TMin() { return Array(kTMin); }
  [[nodiscard]] double* T() { return Array(kT); }

  std::vector<std::size_t> place; ///< in the frame's buffers
  std::vector<int> surface;       ///< number of the surface that was hit

private:
  // What a sample is made of; those up to kKept move when others are dropped.
  enum Column
  {
    kOrigin = 0,
    kDirection = 3,
    kTMin = 6,
    kT = 7,
    kPosition = 8,
    kKept = 11,
    kOtherT = 11,
    kColumns = 15
  };

  void Fit(int count);
  [[nodiscard]] RayLanes CastSome(const Camera& camera, int first, int count, int to);
  HitLanes HitsAt(int column);
  [[nodiscard]] double* Array(int column)
  {
    return &Columns[static_cast<std::size_t>(column) * Stride];
  }
  [[nodiscard]] const double* Array(int column) const
  {
    return &Columns[static_cast<std::size_t>(column) * Stride];
  }

  int Size = 0;
  std::size_t Stride = 0;
  std::vector<double> Columns;
  std::vector<double> U;
  std::vector<double> V;
};

template <class Keep>
void TileSamples::Filter(const Keep& keep)
{
  int kept = 0;
  for (int i = 0; i < Size; ++i)
  {
    if (!keep(i))
    {
      continue;
    }
    if (kept != i)
    {
      const auto from = static_cast<std::size_t>(i);
      const auto to = static_cast<std::size_t>(kept);
      for (int column = 0; column < kKept; ++column)
      {
        Array(column)[to] = Array(column)[from];
      }
      place[to] = place[from];
      surface[to] = surface[from];
    }
    ++kept;
  }
  Size = kept;
}
} // namespace pixelexact
