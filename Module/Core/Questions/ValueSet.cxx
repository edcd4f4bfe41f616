// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Questions/ValueSet.h"

#include <algorithm>

namespace pixelexact
{
bool ValueSet::Meets(double from, double to) const
{
  const auto at = std::ranges::lower_bound(values, from);
  // Written so that a NaN meets.
  return !(from > lower && to < upper) || (at != values.end() && *at <= to);
}
} // namespace pixelexact
