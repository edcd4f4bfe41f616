// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/PointKernels.h"
#include "Core/Tree/ElementTree.h"
#include "Core/Tree/TreeKernels.h"

#include <array>
#include <span>
#include <vector>

namespace pixelexact
{
/// Excludes points of a batch that a bent element does not hold, before any inverse map is
/// computed. Tests all points together against the boxes of the element's tree, whole chunks first,
/// down to boxes that are nearly affine.
class TreeFilter
{
public:
  /// Whether the filter can exclude more than the frame alone; not for an element whose map hardly
  /// bends.
  static bool IsWorthIt(const ElementBounds& bounds);

  /// `kept[k]`: the open points of chunk k that the element might hold, where `near` has the bit k;
  /// at most 64 chunks. Depends on the points and the element alone.
  void Run(ElementTree& tree, const LanePoints& points, std::span<const PointChunk> chunks,
    std::uint64_t near, std::span<std::uint64_t> kept);

  /// A faster form: chunks that most likely lie in the element are kept without a test. Returns a
  /// bit for each. Whether Run would keep their points matters only where the inverse map does not
  /// find them inside.
  std::uint64_t RunButInner(ElementTree& tree, const ElementBounds& bounds,
    const LanePoints& points, std::span<const PointChunk> chunks, std::uint64_t near,
    std::span<std::uint64_t> kept);

private:
  using ChunkBits = std::array<std::uint64_t, kGroupPoints>;

  void Begin(ElementTree& tree, const LanePoints& points, std::span<const PointChunk> chunks,
    std::uint64_t near, std::span<std::uint64_t> kept);
  void Descend(std::uint64_t near);
  [[nodiscard]] std::array<const double*, 3> InUnits(std::size_t chunk);
  [[nodiscard]] std::uint64_t InnerChunks(const ElementBounds& bounds, std::uint64_t near) const;
  void Visit(ElementTree::Node& node, int depth, std::uint64_t active, const ChunkBits& bits);

  const TreeKernels& Kernels = GetTreeKernels();
  ElementTree* Tree = nullptr;
  int MaxSubdivisions = 0;
  double AffineEnough = 0.0;
  BoxesOfGroups Boxes;
  const LanePoints* Points = nullptr;
  std::span<const PointChunk> Chunks;
  std::vector<double> Y;    ///< of each chunk, coordinate by coordinate
  std::uint64_t Scaled = 0; ///< chunks of which it is made
  std::span<std::uint64_t> Kept;
};
} // namespace pixelexact
