// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Questions/EdgeNode.h"
#include "Core/Questions/EdgeWork.h"

#include <array>
#include <atomic>
#include <mutex>
#include <span>

namespace pixelexact
{
/// The cost of visiting a node, in nanoseconds.
inline constexpr std::int64_t kCostOfLook = 50;

/// The tree of an element's boxes of eta with their bounds, each computed on first use. Safe to use
/// from several threads.
class EdgeTree
{
public:
  /// `functions` must outlive the tree, and be finite.
  explicit EdgeTree(const EdgeFunctions& functions)
    : Functions(functions)
  {
  }

  [[nodiscard]] const EdgeNode& Whole() const;
  [[nodiscard]] const std::array<EdgeNode, 2>& Split(const EdgeNode& node) const;
  /// Whether a node may be subdivided: it is not flat or too small, and the budget `work` allows
  /// it; null: without a limit.
  [[nodiscard]] bool CanSplit(const EdgeNode& node, EdgeWork* work) const
  {
    return !node.flat && node.subdivisions < Functions.Deepest(node.regular) &&
      (!work || Affords(node, *work));
  }
  /// The regular child of a regular node that holds all of these eta, with its margin. Null where
  /// there is none, or the budget is exhausted.
  [[nodiscard]] const EdgeNode* SmallerWith(
    const EdgeNode& node, std::span<const Vec3> etas, EdgeWork* work) const;
  /// The largest regular node with this eta; with `straight`, the largest one that is also
  /// straight. Returns the last node visited where there is none, or the budget is exhausted.
  [[nodiscard]] const EdgeNode& LeafAt(
    const Vec3& eta, EdgeWork* work, bool straight = false) const;

private:
  [[nodiscard]] bool Affords(const EdgeNode& node, EdgeWork& work) const;

  const EdgeFunctions& Functions;
  mutable EdgeNode Root;
  mutable std::atomic<bool> HasRoot{ false };
  mutable std::mutex Growing;
};
} // namespace pixelexact
