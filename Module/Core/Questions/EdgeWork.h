// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>

namespace pixelexact
{
struct EdgeNode;

/// Work budget of several queries: samples, visits of nodes, and subdivisions. Each subdivision
/// costs once, whether the tree keeps it from earlier queries or not, so that results do not depend
/// on what is kept. For one thread.
class EdgeWork
{
public:
  /// `most`: in about nanoseconds of one core.
  explicit EdgeWork(std::int64_t most)
    : Most(most)
    , Left(most)
  {
  }

  /// Resets the budget for more queries of the same kind. Subdivisions of earlier queries stay
  /// paid.
  void GoOn(std::int64_t most)
  {
    Most = Left = most;
    Kept = 0;
    Refused = false;
  }
  /// Sets the width, in world units, of the part of a surface that the queries belong to. Larger
  /// boxes serve other queries as well, and cost these queries only their share.
  void SetWidth(double width) { Width = width; }
  /// Bounds the share of a box with these sides that the queries need; 1 where no width is set.
  [[nodiscard]] double PartOf(const std::array<double, 3>& sides) const
  {
    // A surface crosses a box along its two longest sides.
    std::array<double, 3> sorted = sides;
    std::ranges::sort(sorted);
    return Width > 0.0 ? std::min(1.0, Width / sorted[1]) * std::min(1.0, Width / sorted[2]) : 1.0;
  }
  /// From now on reserves this fraction of the budget, 0 to 1, for later queries.
  void Reserve(double part) { Kept = static_cast<std::int64_t>(part * static_cast<double>(Most)); }

  /// Charges work that cannot be refused.
  void Spend(std::int64_t cost) { Left -= cost; }
  /// Whether any budget remains. A refusal is remembered.
  [[nodiscard]] bool IsLeft() { return Affords(0); }
  /// Whether the budget allows the subdivision of a node, which costs `cost` the first time.
  [[nodiscard]] bool Affords(const EdgeNode& node, std::int64_t cost)
  {
    if (Subdivided.contains(&node))
    {
      return IsLeft();
    }
    if (!Affords(cost))
    {
      return false;
    }
    Subdivided.insert(&node);
    return true;
  }
  [[nodiscard]] bool Affords(std::int64_t cost)
  {
    const bool enough = cost < Left - Kept;
    Left -= enough ? cost : 0;
    Refused = Refused || !enough;
    return enough;
  }

  [[nodiscard]] std::int64_t Spent() const { return Most - Left; }
  /// Whether any work was refused.
  [[nodiscard]] bool IsSpent() const { return Refused; }

private:
  std::unordered_set<const EdgeNode*> Subdivided;
  double Width = 0.0;
  std::int64_t Most;
  std::int64_t Left;
  std::int64_t Kept = 0;
  bool Refused = false;
};
} // namespace pixelexact
