// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>

namespace pixelexact
{
/// Values that are looked for: some numbers, in ascending order, and all that are not between two.
struct ValueSet
{
  std::span<const double> values;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  /// Whether one of them is in an interval.
  [[nodiscard]] bool Meets(double from, double to) const;
};
} // namespace pixelexact
