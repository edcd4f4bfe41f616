// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace pixelexact
{
/// The values for a given number of contours, in all programs: `count` round values strictly inside
/// `range`, in ascending order. They are equally spaced; step and values are whole multiples of 1,
/// 2, 2.5 or 5 times a power of ten, the coarsest one with which exactly `count` such values fit
/// and a further one before or after them does not. A value within a twentieth of the step from an
/// end counts as that end. `logarithm`: powers of ten, their multiples by 1, 2 and 5, or numbers of
/// few digits, the coarsest ones that are spaced as equally by their logarithms as a fifth of a
/// step. Empty where `count` < 1, where the ends are not finite, not ascending or (`logarithm`) not
/// above 0, or too close to each other for that many distinct doubles.
[[nodiscard]] std::vector<double> RoundValues(
  int count, const std::array<double, 2>& range, bool logarithm = false);
} // namespace pixelexact
