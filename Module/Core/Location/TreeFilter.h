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
/// Tells, before any inverse map is made, which of a batch's points a bent element surely does not
/// hold: all of them together against the boxes of its tree, down to boxes that are nearly affine.
/// Whole chunks of points are told first.
class TreeFilter
{
public:
  /// Whether it is worth it: of an element whose map hardly bends the frame alone tells as much.
  static bool IsWorthIt(const ElementBounds& bounds);

  /// `kept[k]`: of chunk k's open points those that the element might hold, where `near` has the
  /// bit k; at most 64 chunks. Depends on the points and the element alone.
  void Run(ElementTree& tree, const LanePoints& points, std::span<const PointChunk> chunks,
    std::uint64_t near, std::span<std::uint64_t> kept);

  /// The same in less time: chunks that most likely lie in the element are kept without any test.
  /// Returns a bit for each. Whether Run would keep their points matters only where the inverse map
  /// does not find them inside.
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
