// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/RayBundle.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Boxes in a binary tree, for bundles of rays. Embree's hierarchies are asked by single rays and
/// by packets of 16: neighbouring rays meet the same boxes, and ask for them once here.
class BundleHierarchy
{
public:
  explicit BundleHierarchy(std::span<const Box3> boxes);

  /// Calls visit for the numbers of all boxes, and these, that rays of the bundle may meet, about
  /// in the order of their depths. What lies behind all of the rays' ends (RayBundle::EndAt) is
  /// left out.
  void ForEach(const RayBundle& bundle, const std::function<void(int, const Box3&)>& visit) const;

  /// Of all boxes.
  [[nodiscard]] const Box3& Bounds() const { return Nodes.front().bounds; }

private:
  struct Node
  {
    Box3 bounds;
    std::int32_t child = -1; ///< of two; -1: a leaf
    std::int32_t first = 0;  ///< of a leaf's boxes
    std::int32_t count = 0;
  };
  void Build(std::size_t node, std::span<const Box3> boxes, int first, int count);

  std::vector<Node> Nodes;
  std::vector<std::int32_t> Order;
  std::vector<Box3> Boxes; ///< in that order
};
} // namespace pixelexact
