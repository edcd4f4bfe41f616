// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/Batch.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pixelexact
{
/// The boxes of chunks that are searched together.
class ChunkBoxes
{
public:
  static constexpr std::size_t kGroup = 64;

  void Fill(std::span<const PointChunk> chunks)
  {
    Count = chunks.size();
    Stride = static_cast<std::size_t>(PaddedCount(static_cast<int>(Count)));
    if (Coordinates.size() < 6 * Stride)
    {
      Coordinates.resize(6 * Stride);
    }
    for (std::size_t k = 0; k < Stride; ++k)
    {
      for (std::size_t d = 0; d < 3; ++d)
      {
        const auto axis = static_cast<int>(d);
        Coordinates[d * Stride + k] = k < Count ? chunks[k].box.lower[axis] : 1.0;
        Coordinates[(3 + d) * Stride + k] = k < Count ? chunks[k].box.upper[axis] : -1.0;
      }
    }
  }

  /// The boxes of at most kGroup chunks from `first` on.
  [[nodiscard]] BoxLanes Group(std::size_t first) const
  {
    const double* at = &Coordinates[first];
    return { { at, at + Stride, at + 2 * Stride },
      { at + 3 * Stride, at + 4 * Stride, at + 5 * Stride },
      static_cast<int>(std::min(kGroup, Count - first)) };
  }

private:
  std::size_t Count = 0;
  std::size_t Stride = 0;
  std::vector<double> Coordinates;
};
/// The arrays of a batch.
struct Locator::Batch::Scratch
{
  std::vector<double> lanes;
  std::size_t stride = 0;
  std::vector<PointChunk> chunks;
  ChunkBoxes boxes;
  std::vector<std::vector<int>> candidates; ///< by depth of subdivision
  std::size_t depth = 0;
  TreeFilter filter;
  std::array<std::uint64_t, ChunkBoxes::kGroup> kept{}; ///< by the filter, of each chunk
  std::vector<std::uint64_t> untested; ///< by the filter: chunks of each group, a bit each
  std::vector<PointChunk> late;        ///< of which the filter is to see points
  std::vector<int> selected;           ///< the batch's index of each selected point
  std::vector<int> others;             ///< which of the selected were not found inside
  std::vector<Doubt> doubtful;
  std::vector<int> doubts;          ///< of each point
  std::vector<PointBudget> budgets; ///< of each point
  std::vector<Doubt> group;
  std::vector<Doubt> undecided;

  void Fit(int points)
  {
    // Packs are stored whole, beyond the last point.
    const auto needed = static_cast<std::size_t>(PaddedCount(points)) + kLanePadding;
    if (stride < needed)
    {
      stride = needed;
      lanes.resize(9 * stride);
      selected.resize(stride);
      others.resize(stride);
    }
    depth = 0;
  }
  double* operator[](std::size_t array) { return &lanes[array * stride]; }
};
} // namespace pixelexact
