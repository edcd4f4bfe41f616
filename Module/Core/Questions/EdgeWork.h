// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_set>

namespace pixelexact
{
struct EdgeNode;

/// What some questions may spend together, on samples and on halving nodes that are small already:
/// each of these costs once, whether its halves are kept from earlier questions or not, so that
/// answers do not depend on what is kept. Large nodes are few, and free. For one thread.
class EdgeWork
{
public:
  /// `most`: about the nanoseconds of one core.
  explicit EdgeWork(std::int64_t most)
    : Left(most)
  {
  }

  /// Whether the halves of a node may be looked at, which costs so much the first time.
  [[nodiscard]] bool Affords(const EdgeNode& node, std::int64_t cost)
  {
    if (!Halved.insert(&node).second)
    {
      return true;
    }
    if (!Affords(cost))
    {
      Halved.erase(&node);
      return false;
    }
    return true;
  }
  [[nodiscard]] bool Affords(std::int64_t cost)
  {
    const bool enough = cost <= Left;
    Left -= enough ? cost : 0;
    Refused = Refused || !enough;
    return enough;
  }

  /// Whether anything was left undone for want of work.
  [[nodiscard]] bool IsSpent() const { return Refused; }

private:
  std::unordered_set<const EdgeNode*> Halved;
  std::int64_t Left;
  bool Refused = false;
};
} // namespace pixelexact
