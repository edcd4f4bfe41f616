// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/PointSearch.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace pixelexact
{
/// Work budget of a point, divided between the elements whose own Newton iteration leaves it open.
/// Up to kFew elements share all of it. More elements share half; the other half is reserved for
/// elements that need more, in order.
class PointBudget
{
public:
  explicit PointBudget(int elements)
    : share_((elements > kFew ? kMaxWork / 2 : kMaxWork) / std::max(elements, 1))
    , Rest(elements > kFew ? kMaxWork / 2 : 0)
  {
  }

  /// The budget of each element.
  [[nodiscard]] std::int64_t Share() const { return share_; }
  /// The additional budget of an element that has exhausted its share, for a second pass; 0 where
  /// the remaining budget is no more than the share.
  std::int64_t TakeMore()
  {
    const std::int64_t more = std::min(Rest, kMaxMore);
    if (more <= share_)
    {
      return 0;
    }
    Rest -= more;
    return more;
  }

private:
  static constexpr int kFew = 4;
  static constexpr std::int64_t kMaxMore = 1'000'000;

  std::int64_t share_;
  std::int64_t Rest;
};

/// Calls FindPreimages with the budget of each point. Sets `mostWork` of `points`.
void FindWithin(ElementTree& tree, std::span<SoughtPoint> points,
  std::span<PointBudget* const> budgets, Wanted wanted, std::span<Preimages> answers);
} // namespace pixelexact
