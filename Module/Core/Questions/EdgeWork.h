// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>

namespace pixelexact
{
struct EdgeNode;

/// What some questions may spend together, on samples, on looking at nodes and on halving them:
/// each halving costs once, whether its halves are kept from earlier questions or not, so that
/// answers do not depend on what is kept. For one thread.
class EdgeWork
{
public:
  /// `most`: about the nanoseconds of one core.
  explicit EdgeWork(std::int64_t most)
    : Most(most)
    , Left(most)
  {
  }

  /// For more questions of the same kind: what was halved for earlier ones is not paid again.
  void GoOn(std::int64_t most)
  {
    Most = Left = most;
    Kept = 0;
    Refused = false;
  }
  /// The questions are of a part of a surface that is about as wide, in world units: what is made
  /// of larger boxes serves others, too, and costs these as large a part as they see of it.
  void SetWidth(double width) { Width = width; }
  /// The part that they see of a box with these sides, at most; all, where there is no width.
  [[nodiscard]] double PartOf(const std::array<double, 3>& sides) const
  {
    // A surface meets what lies across two of them.
    std::array<double, 3> sorted = sides;
    std::ranges::sort(sorted);
    return Width > 0.0 ? std::min(1.0, Width / sorted[1]) * std::min(1.0, Width / sorted[2]) : 1.0;
  }
  /// From now on so much of it has to be left, for questions that come later: a part, 0 to 1.
  void Reserve(double part) { Kept = static_cast<std::int64_t>(part * static_cast<double>(Most)); }

  /// Looks at something, which is done anyhow.
  void Spend(std::int64_t cost) { Left -= cost; }
  /// Whether any is left; what is not done for want of it is remembered.
  [[nodiscard]] bool IsLeft() { return Affords(0); }
  /// Whether the halves of a node may be looked at, which costs so much the first time.
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
  /// Whether anything was left undone for want of work.
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
