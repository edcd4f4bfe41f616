// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/RayBundle.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Boxes in a tree of nodes of eight, for bundles of rays. Embree's hierarchies take single rays or
/// packets of 16. Neighbouring rays meet the same boxes, and one query serves a whole bundle here.
class BundleHierarchy
{
public:
  explicit BundleHierarchy(std::span<const Box3> boxes);

  /// Calls visit(number, box) for all boxes that rays of the bundle may meet, approximately in
  /// order of depth. Boxes after all rays' ends (RayBundle::EndAt) are skipped.
  void ForEach(const RayBundle& bundle, const std::function<void(int, const Box3&)>& visit) const;

  /// The box around all boxes.
  [[nodiscard]] const Box3& Bounds() const { return bounds_; }

private:
  struct Node
  {
    EightBoxes boxes;
    /// For each box: the number of its node or, for a leaf, -1 - its index in Order.
    std::array<std::int32_t, EightBoxes::kMax> below{};
  };
  /// Adds the node of `count` boxes from index `first` of Order on. Returns its number.
  std::int32_t Build(std::span<const Box3> boxes, int first, int count);

  std::vector<Node> Nodes; ///< the first one is the root
  std::vector<std::int32_t> Order;
  std::vector<Box3> Boxes; ///< in that order
  Box3 bounds_;
};
} // namespace pixelexact
