// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Trace/Surfaces/Curved/RayBundle.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pixelexact
{
/// Boxes in a tree of nodes of eight, for bundles of rays. Embree's hierarchies are asked by single
/// rays and by packets of 16: neighbouring rays meet the same boxes, and ask for them once here.
class BundleHierarchy
{
public:
  explicit BundleHierarchy(std::span<const Box3> boxes);

  /// Calls visit for the numbers of all boxes, and these, that rays of the bundle may meet, about
  /// in the order of their depths. What lies behind all of the rays' ends (RayBundle::EndAt) is
  /// left out.
  void ForEach(const RayBundle& bundle, const std::function<void(int, const Box3&)>& visit) const;

  /// Of all boxes.
  [[nodiscard]] const Box3& Bounds() const { return bounds_; }

private:
  struct Node
  {
    EightBoxes boxes;
    /// Of each box: the number of its node; of one that is no node's, -1 - its place in Order.
    std::array<std::int32_t, EightBoxes::kMax> below{};
  };
  /// Of the boxes at some places in Order: their node, which is added.
  std::int32_t Build(std::span<const Box3> boxes, int first, int count);

  std::vector<Node> Nodes; ///< the first one is the root
  std::vector<std::int32_t> Order;
  std::vector<Box3> Boxes; ///< in that order
  Box3 bounds_;
};
} // namespace pixelexact
