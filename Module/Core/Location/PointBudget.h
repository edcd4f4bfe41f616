// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Core/Location/PointSearch.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace pixelexact
{
/// What a point may cost, divided between the elements whose own Newton iteration leaves it open.
/// Few share all of it. Of many, most need little: half is kept for those that need more, the first
/// ones first.
class PointBudget
{
public:
  explicit PointBudget(int elements)
    : share_((elements > kFew ? kMaxWork / 2 : kMaxWork) / std::max(elements, 1))
    , Rest(elements > kFew ? kMaxWork / 2 : 0)
  {
  }

  /// Of each element.
  [[nodiscard]] std::int64_t Share() const { return share_; }
  /// What an element may cost that has used up its share, when it is asked anew; nothing where what
  /// is left is no more than the share.
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

/// FindPreimages, each point within its budget. `points`: their `mostWork` is set here.
void FindWithin(ElementTree& tree, std::span<SoughtPoint> points,
  std::span<PointBudget* const> budgets, Wanted wanted, std::span<Preimages> answers);
} // namespace pixelexact
