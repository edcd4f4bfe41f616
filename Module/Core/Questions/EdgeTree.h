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

/// What is known of an element's boxes of eta, each made where somebody first asks. Safe to use
/// from several threads.
class EdgeTree
{
public:
  /// `functions` must outlive it, and be finite where nodes are asked for.
  explicit EdgeTree(const EdgeFunctions& functions)
    : Functions(functions)
  {
  }

  [[nodiscard]] const EdgeNode& Whole() const;
  [[nodiscard]] const std::array<EdgeNode, 2>& Split(const EdgeNode& node) const;
  /// Whether halves of a node are worth it, and `work` is left for them; null: any.
  [[nodiscard]] bool CanSplit(const EdgeNode& node, EdgeWork* work) const
  {
    return !node.flat && node.subdivisions < Functions.Deepest(node.regular) &&
      (!work || Affords(node, *work));
  }
  /// The regular half of a regular node that holds all of these eta, with its margin; null where
  /// there is none, or no work is left for it.
  [[nodiscard]] const EdgeNode* SmallerWith(
    const EdgeNode& node, std::span<const Vec3> etas, EdgeWork* work) const;
  /// The largest regular node with this eta, that is straight, too, if so wanted; the last one,
  /// where there is none.
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
